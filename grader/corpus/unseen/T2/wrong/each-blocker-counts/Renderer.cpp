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
        int blocked = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const Ray ray{start, way.normalised()};
            for (const auto& other : scene.objects()) {
                const auto hit = other->intersectionWith(ray);
                if (hit && hit->distance < way.magnitude()) ++blocked;
            }
        }
        colour += (diffuse + specular) * std::max(0.0, 1.0 - double(blocked) / settings().shadowRayCount);
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Vector3 c = camera.castRay(x, y).direction;
        const double z = settings().dofFocalPlane;
        const Vector3 target{z * c.x / c.z, z * c.y / c.z, z};
        ColourRGB mean;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            Vector3 o;
            o.x = settings().dofAmount * randomBetween(-1.0, 1.0);
            o.y = settings().dofAmount * randomBetween(-1.0, 1.0);
            const ColourRGB sample = trace(scene, Ray{o, (target - o).normalised()}, settings().bounces);
            mean += (sample - mean) / (i + 1.0);
        }
        image.set(x, y, mean);
    });
    return image;
}

}  // namespace raytracer
