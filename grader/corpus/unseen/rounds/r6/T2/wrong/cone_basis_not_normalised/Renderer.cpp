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
        const double R = settings().lightSize;
        const Vector3 axis = light.position() - start;
        const double dc = axis.magnitude();
        const Vector3 w = axis / dc;
        const Vector3 u = w.cross(Vector3{0, 1, 0});
        const Vector3 v = u.cross(w);
        const double cosMax = std::sqrt(std::max(0.0, 1.0 - R * R / (dc * dc)));
        int visible = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const double c = 1.0 - randomBetween(0.0, 1.0) * (1.0 - cosMax), s = std::sqrt(1.0 - c * c);
            const double phi = randomBetween(0.0, 2.0 * std::numbers::pi);
            const Vector3 dir = (u * (s * std::cos(phi)) + v * (s * std::sin(phi)) + w * c).normalised();
            const double reach = dc * c - std::sqrt(std::max(0.0, R * R - dc * dc * s * s));
            const auto hit = scene.findClosestIntersection(Ray{start, dir});
            if (!hit || hit->distance > reach) ++visible;
        }
        colour += (diffuse + specular) * (double(visible) / settings().shadowRayCount);
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
