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
        const auto arrives = [&](int) {
            const Vector3 way = light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize - start;
            const auto hit = scene.findClosestIntersection(Ray{start, way});   // way is parameter 0..1
            return !(hit && hit->distance < 1.0);
        };
        const auto count = std::ranges::count_if(std::views::iota(0, settings().shadowRayCount), arrives);
        colour += (diffuse + specular) * (double(count) / settings().shadowRayCount);
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
        const double cell = 2.0 * settings().dofAmount / side;
        ColourRGB sum;
        for (int k = 0; k < side * side; ++k) {
            const int i = k / side, j = k / side;
            const Vector3 lens{-settings().dofAmount + cell * (i + randomBetween(0, 1)), -settings().dofAmount + cell * (j + randomBetween(0, 1)), 0.0};
            sum += trace(scene, Ray{lens, (focal - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / (side * side));
    });
    return image;
}

}  // namespace raytracer
