// render.py by hand: [f(s) for s in samples], sum(), zip
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ranges>
#include <tuple>
#include <utility>
#include <vector>

namespace raytracer {

namespace {

// [f() for _ in range(n)]
template <class F>
auto listOf(int n, F f) {
    std::vector<decltype(f())> out;
    for (int i = 0; i < n; ++i) out.push_back(f());
    return out;
}
// [f(x) for x in xs]
template <class Xs, class F>
auto mapped(const Xs& xs, F f) {
    std::vector<decltype(f(*xs.begin()))> out;
    for (const auto& x : xs) out.push_back(f(x));
    return out;
}
template <class Xs>
auto mean(const Xs& xs) {
    typename Xs::value_type s{};
    for (const auto& x : xs) s = s + x;
    return s / static_cast<double>(xs.size());
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

        // TASK T2.1 begin
        const auto origin = P + N * kShadowBias;
        const auto targets = listOf(settings().shadowRayCount, [&] {
            return light.position() + settings().lightSize * Vector3::randomInsideUnitSphere();
        });
        // visible = [1.0 if all(t > 1 for t in hits) else 0.0]
        const auto visible = mapped(targets, [&](const Vector3& target) {
            // not normalised: distances are counted in lengths of the way, the light is at 1
            const auto hit = scene.findClosestIntersection(Ray{origin, target - origin});
            return hit && hit->distance < 1.0 ? 0.0 : 1.0;
        });
        colour += (diffuse + specular) * mean(visible);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const auto s = settings();
        const auto pinhole = camera.castRay(x, y).direction;
        const auto [fx, fy, fz] = std::tuple{pinhole.x / pinhole.z * s.dofFocalPlane, pinhole.y / pinhole.z * s.dofFocalPlane, s.dofFocalPlane};
        const Vector3 focus{fx, fy, fz};
        const auto lens = listOf(s.dofRayCount, [&] {
            const double lx = randomBetween(-s.dofAmount, s.dofAmount);
            return Vector3{lx, randomBetween(-s.dofAmount, s.dofAmount), 0};
        });
        image.set(x, y, mean(mapped(lens, [&](const Vector3& p) {
            return trace(scene, Ray{p, (focus - p).normalised()}, s.bounces);
        })));
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
