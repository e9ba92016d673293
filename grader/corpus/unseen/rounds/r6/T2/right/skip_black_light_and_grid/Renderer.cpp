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
        const ColourRGB light_ = diffuse + specular;
        if (light_.r + light_.g + light_.b <= 0.0) continue;  // nothing that could be shadowed
        double share = 0.0;
        for (int i = 1; i <= settings().shadowRayCount; ++i) {
            const Vector3 start = P + N * kShadowBias;
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way.normalised()});
            const double arrived = (hit && hit->distance < way.magnitude()) ? 0.0 : 1.0;
            share += (arrived - share) / i;   // running mean
        }
        colour += light_ * share;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        const int side = static_cast<int>(std::ceil(std::sqrt(settings().dofRayCount)));
        ColourRGB sum;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const double s = -1.0 + 2.0 * (i + randomBetween(0.0, 1.0)) / side;
                const double t = -1.0 + 2.0 * (j + randomBetween(0.0, 1.0)) / side;
                const Vector3 lens{s * settings().dofAmount, t * settings().dofAmount, 0.0};
                sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
            }
        image.set(x, y, sum / (side * side));
    });
    return image;
}

}  // namespace raytracer
