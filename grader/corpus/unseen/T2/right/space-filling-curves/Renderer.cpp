// Option 2, tasks T2.1 and T2.2: soft shadows and depth of field.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <array>

namespace raytracer {

namespace {
/// A point of the unit square, t of the way along Hilbert's curve; even if t is even in [0, 1).
std::array<double, 2> hilbert(double t, int depth = 20) {
    if (depth == 0) return {randomBetween(0, 1), randomBetween(0, 1)};
    t *= 4;
    const int quarter = std::min(3, static_cast<int>(t));
    const auto [a, b] = hilbert(t - quarter, depth - 1);
    switch (quarter) {
        case 0: return {b / 2, a / 2};
        case 1: return {a / 2, b / 2 + 0.5};
        case 2: return {a / 2 + 0.5, b / 2 + 0.5};
        default: return {1 - b / 2, 0.5 - a / 2};
    }
}

/// The same along Morton's curve in the unit cube: bits of t go round among the axes.
std::array<double, 3> morton(double t) {
    std::array<double, 3> p{};
    double bit = 1;
    for (int level = 0; level < 15; ++level) {
        bit /= 2;
        for (double& axis : p) {
            t *= 2;
            if (t >= 1) axis += bit, t -= 1;
        }
    }
    for (double& axis : p) axis += bit * randomBetween(0, 1);
    return p;
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
        const int n = settings().shadowRayCount;
        int reach = 0;
        for (int i = 0; i < n; ++i) {
            const auto [a, b, c] = morton((i + randomBetween(0, 1)) / n);
            const double h = 1 - 2 * a, turn = 2 * std::numbers::pi * b, flat = std::sqrt(1 - h * h);
            const Vector3 in = std::cbrt(c) * Vector3{flat * std::cos(turn), h, flat * std::sin(turn)};
            const Vector3 path = light.position() + in * settings().lightSize - P;
            const auto hit = scene.findClosestIntersection({P + N * kShadowBias, path.normalised()});
            if (hit && hit->distance < path.magnitude()) continue;
            ++reach;
        }
        colour += (diffuse + specular) * (static_cast<double>(reach) / n);
        // TASK T2.1 end
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // TASK T2.2 begin
        const int n = settings().dofRayCount;
        const Ray pin = camera.castRay(x, y);
        const Vector3 focus = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        ColourRGB sum;
        for (int i = 0; i < n; ++i) {
            const auto [a, b] = hilbert((i + randomBetween(0, 1)) / n);
            const Vector3 lens{settings().dofAmount * (2 * a - 1), settings().dofAmount * (2 * b - 1), 0};
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / n);
        // TASK T2.2 end
    });
    return image;
}

}  // namespace raytracer
