// Option 2, tasks T2.1 and T2.2.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <ranges>
#include <utility>
#include <vector>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    const Vector3 toViewer = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();

    for (const PointLight& light : scene.pointLights()) {
        const double distance = (light.position() - P).magnitude();
        const Vector3 toLight = (light.position() - P).normalised();
        const ColourRGB arriving = light.illuminationAt(distance);

        const double facing = std::max(0.0, N.dot(toLight));
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * facing);

        const double mirrored = std::max(0.0, toLight.reflectIn(N).dot(toViewer));
        const ColourRGB specular = light.colour() * arriving *
                                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
        const Vector3 start = P + N * kShadowBias;
        Vector3 offset;
        int reached = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            offset = i % 2 == 0 ? Vector3::randomInsideUnitSphere() * settings().lightSize : -offset;
            const Vector3 way = light.position() + offset - start;
            const auto hit = scene.findClosestIntersection({start, way.normalised()});
            reached += hit && hit->distance < way.magnitude() ? 0 : 1;
        }
        colour += (diffuse + specular) * (double(reached) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // thin lens: slope' = slope - height / f with 1/f = 1/film + 1/object
        const Vector3 d = camera.castRay(x, y).direction;
        const double power = 1.0 / 1.0 + 1.0 / settings().dofFocalPlane;
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            const double lx = settings().dofAmount * randomBetween(-1.0, 1.0);
            const double ly = settings().dofAmount * randomBetween(-1.0, 1.0);
            const Vector3 out{d.x / d.z - lx * power, d.y / d.z - ly * power, 1.0};
            sum += trace(scene, Ray{{lx, ly, 0.0}, out.normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
