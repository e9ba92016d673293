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
namespace {

/// Any hit will do: no need for the nearest one.
bool segmentBlocked(const Scene& scene, const Vector3& a, const Vector3& b) {
    const Ray segment{a, b - a};
    return std::ranges::any_of(scene.objects(), [&](const auto& object) {
        const auto hit = object->intersectionWith(segment);
        return hit && hit->distance < 1.0;
    });
}

}  // namespace

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
        const Vector3 origin = P + N * kShadowBias;
        int free = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            free += !segmentBlocked(scene, origin, light.position() + settings().lightSize * Vector3::randomInsideUnitSphere());
        const double share = free / double(settings().shadowRayCount);
        colour += (diffuse + specular) * share;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray pin = camera.castRay(x, y);
        const Vector3 focal = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        const auto tent = [] { return randomBetween(0.0, 1.0) + randomBetween(0.0, 1.0) - 1.0; };  // -1 .. 1
        ColourRGB sum;
        for (int i = 0; i < settings().dofRayCount; ++i) {
            Vector3 lens;
            lens.x = settings().dofAmount * tent();
            lens.y = settings().dofAmount * tent();
            sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
