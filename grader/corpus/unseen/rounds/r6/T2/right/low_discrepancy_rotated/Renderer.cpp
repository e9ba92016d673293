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

double frac(double x) { return x - std::floor(x); }

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
        // A Kronecker sequence in the cube (solutions of x^4 = x + 1), rotated at random
        // (Cranley and Patterson), mapped to the ball by r = cbrt(a), z = 1 - 2 b.
        const double g = 1.2207440846057596;
        const double o1 = randomBetween(0, 1), o2 = randomBetween(0, 1), o3 = randomBetween(0, 1);
        const Vector3 from = P + kShadowBias * N;
        const int n = settings().shadowRayCount;
        int lit = n;
        for (int k = 1; k <= n; ++k) {
            const double r = settings().lightSize * std::cbrt(frac(o1 + k / g));
            const double z = 1 - 2 * frac(o2 + k / (g * g));
            const double phi = 2 * std::numbers::pi * frac(o3 + k / (g * g * g));
            const double s = std::sqrt(1 - z * z);
            const Vector3 way = light.position() + r * Vector3{s * std::cos(phi), s * std::sin(phi), z} - from;
            const auto hit = scene.findClosestIntersection(Ray{from, way.normalised()});
            if (hit && hit->distance * hit->distance < way.dot(way)) --lit;
        }
        colour += (diffuse + specular) * (static_cast<double>(lit) / n);
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
