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

/// Archimedes' hat-box in five dimensions: three of the five coordinates of a uniform point on the
/// sphere S^4 are uniform in the ball B^3. No cube root, no rejection.
Vector3 ballPoint() {
    double g[6];
    for (int k = 0; k < 6; k += 2) {
        const double r = std::sqrt(-2.0 * std::log(1.0 - randomBetween(0.0, 1.0)));
        const double a = randomBetween(0.0, 2.0 * std::numbers::pi);
        g[k] = r * std::cos(a);
        g[k + 1] = r * std::sin(a);
    }
    const double length = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] + g[3] * g[3] + g[4] * g[4]);
    return {g[0] / length, g[1] / length, g[2] / length};
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
        double seen = 0.0;
        for (int i = 0; i < settings().shadowRayCount; ++i) {
            const Vector3 end = light.position() + settings().lightSize * ballPoint();
            const Vector3 way = end - start;
            const double length = way.magnitude();
            const auto hit = scene.findClosestIntersection({start, way / length});
            seen += hit && hit->distance < length ? 0.0 : 1.0;
        }
        const double share = seen / settings().shadowRayCount;
        colour += diffuse * share;
        colour += specular * share;
    }
    return colour;
}

Image Renderer::render(const Scene& scene) const {
    const Camera camera{settings()};
    Image image{settings()};
    forEachPixel(image, [&](int x, int y) {
        const Ray eye = camera.castRay(x, y);
        const Vector3 focus = eye.direction * (settings().dofFocalPlane / eye.direction.z);
        ColourRGB sum;
        int rays = 0;
        do {
            // uniform in the circumscribed disc; what falls outside of the square is thrown away
            const double r = std::sqrt(2.0 * randomBetween(0.0, 1.0));
            const double a = randomBetween(-std::numbers::pi, std::numbers::pi);
            const double s = r * std::cos(a), t = r * std::sin(a);
            if (std::max(std::abs(s), std::abs(t)) > 1.0) continue;
            const Vector3 lens{settings().dofAmount * s, settings().dofAmount * t, 0.0};
            sum += trace(scene, Ray{lens, (focus - lens).normalised()}, settings().bounces);
            ++rays;
        } while (rays < settings().dofRayCount);
        image.set(x, y, sum * (1.0 / rays));
    });
    return image;
}

}  // namespace raytracer
