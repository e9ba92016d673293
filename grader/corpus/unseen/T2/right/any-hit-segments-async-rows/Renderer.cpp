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
    const int workers = std::max(1, settings().threads);
    const auto band = [&](int first) {
        for (int y = first; y < image.height(); y += workers) {
            seedRandom(settings().seed * 1000003u + static_cast<unsigned>(y));
            for (int x = 0; x < image.width(); ++x) {
                const Vector3 d = camera.castRay(x, y).direction;
                const Vector3 focal = d / d.z * settings().dofFocalPlane;
                ColourRGB sum;
                for (int i = 0; i < settings().dofRayCount; ++i) {
                    const Vector3 lens{settings().dofAmount * randomBetween(-1, 1),
                                       settings().dofAmount * randomBetween(-1, 1), 0};
                    sum += trace(scene, {lens, (focal - lens).normalised()}, settings().bounces);
                }
                image.set(x, y, sum / settings().dofRayCount);
            }
        }
    };
    std::vector<std::future<void>> bands;
    for (int w = 1; w < workers; ++w) bands.push_back(std::async(std::launch::async, band, w));
    band(0);
    for (auto& b : bands) b.get();
    return image;
}

}  // namespace raytracer
