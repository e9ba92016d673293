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
        const Plane focalPlane{{0.0, 0.0, settings().dofFocalPlane}, {0.0, 0.0, -1.0}, Material{}};
        const Vector3 focalPoint = focalPlane.intersectionWith(camera.castRay(x, y))->location;
        std::vector<Vector3> lens(settings().dofRayCount);
        std::ranges::generate(lens, [&] {
            const double a = settings().dofAmount;
            return Vector3{randomBetween(-a, a), randomBetween(-a, a), 0.0};
        });
        const ColourRGB sum = std::transform_reduce(lens.begin(), lens.end(), ColourRGB{}, std::plus<>{}, [&](const Vector3& from) {
            return trace(scene, Ray{from, (focalPoint - from).normalised()}, settings().bounces);
        });
        image.set(x, y, sum / static_cast<double>(lens.size()));
    });
    return image;
}

}  // namespace raytracer
