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

/// Whether the segment from a to b misses every sphere. (Planes are floors: nothing stands below.)
bool spheresLetThrough(const Scene& scene, const Vector3& a, const Vector3& b) {
    const Vector3 d = b - a;
    for (const auto& object : scene.objects()) {
        const auto* ball = dynamic_cast<const Sphere*>(object.get());
        if (ball == nullptr) continue;
        const Vector3 m = a - ball->centre();
        const double A = d.dot(d), B = m.dot(d), C = m.dot(m) - ball->radius() * ball->radius();
        const double disc = B * B - A * C;
        if (disc < 0.0) continue;
        const double root = std::sqrt(disc);
        for (const double t : {(-B - root) / A, (-B + root) / A})
            if (t > 0.0 && t < 1.0) return false;
    }
    return true;
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
        const Vector3 start = P + N * kShadowBias;
        int arrived = 0;
        for (int i = 0; i < settings().shadowRayCount; ++i)
            arrived += spheresLetThrough(scene, start, light.position() + Vector3::randomInsideUnitSphere() * settings().lightSize);
        colour += (diffuse + specular) * (arrived / static_cast<double>(settings().shadowRayCount));
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        // R2 sequence (Roberts), shifted at random for each pixel
        const Ray pin = camera.castRay(x, y);
        const Vector3 focus = pin.evaluateAt(settings().dofFocalPlane / pin.direction.z);
        const double p = 1.32471795724474602596;
        const double ox = randomBetween(0.0, 1.0), oy = randomBetween(0.0, 1.0);
        ColourRGB sum;
        for (int i = 1; i <= settings().dofRayCount; ++i) {
            const double a = ox + i / p, b = oy + i / (p * p);
            const Vector3 lens = Vector3{2 * (a - std::floor(a)) - 1, 2 * (b - std::floor(b)) - 1, 0} * settings().dofAmount;
            sum += trace(scene, {lens, (focus - lens).normalised()}, settings().bounces);
        }
        image.set(x, y, sum / settings().dofRayCount);
    });
    return image;
}

}  // namespace raytracer
