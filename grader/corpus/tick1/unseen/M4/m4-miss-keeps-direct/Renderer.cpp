// Tasks M2, M3.2 and M4: Phong illumination, shadows and reflections.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

namespace raytracer {
namespace {

// Whether something stands between the point P, whose surface has the normal N, and the light.
bool isShadowed(const Scene& scene, const PointLight& light, const Vector3& P, const Vector3& N) {
    // TASK M3.2 begin
    const Vector3 start = P + N * kShadowBias;
    const double dx = light.position().x - start.x;
    const double dy = light.position().y - start.y;
    const double dz = light.position().z - start.z;
    const double lightDistance = std::hypot(dx, dy, dz);
    if (lightDistance == 0.0) return false;
    const Vector3 direction{dx / lightDistance, dy / lightDistance, dz / lightDistance};
    const auto hit = scene.findClosestIntersection(Ray{start, direction});
    if (!hit) return false;
    if (hit->distance >= lightDistance) return false;
    return true;
    // TASK M3.2 end
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK M2 begin
    const ColourRGB Cd = object.colour();
    const ColourRGB Ia = scene.ambientLighting();
    double red = Cd.r * Ia.r, green = Cd.g * Ia.g, blue = Cd.b * Ia.b;
    const double kd = object.phongKD(), ks = object.phongKS(), alpha = object.phongAlpha();
    const Vector3 n = N.normalised();
    const Vector3 V = (O - P).normalised();
    for (std::size_t i = 0; i < scene.pointLights().size(); ++i) {
        const PointLight& light = scene.pointLights()[i];
        if (isShadowed(scene, light, P, n)) continue;
        const Vector3 difference = light.position() - P;
        const double d2 = difference.dot(difference);
        const Vector3 L = difference / std::sqrt(d2);
        const double NL = n.dot(L);
        const Vector3 R{2 * NL * n.x - L.x, 2 * NL * n.y - L.y, 2 * NL * n.z - L.z};
        const double strength = light.intensity() / (4 * std::numbers::pi * d2);
        const double D = kd * std::fmax(NL, 0) * strength;
        const double S = ks * std::pow(std::fmax(R.dot(V), 0), alpha) * strength;
        const ColourRGB Cs = light.colour();
        red += Cd.r * D * Cs.r + Cs.r * S * Cs.r;
        green += Cd.g * D * Cs.g + Cs.g * S * Cs.g;
        blue += Cd.b * D * Cs.b + Cs.b * S * Cs.b;
    }
    return {red, green, blue};
    // TASK M2 end
}

ColourRGB Renderer::trace(const Scene& scene, const Ray& ray, int bouncesLeft) const {
    const std::optional<RaycastHit> hit = scene.findClosestIntersection(ray);
    if (!hit) return kBackgroundColour;
    const SceneObject& object = *hit->object;
    const Vector3 P = hit->location;
    const Vector3 N = hit->normal;
    const ColourRGB direct = illuminate(scene, object, P, N, ray.origin);
    // TASK M4 begin
    const double rho = object.reflectivity();
    if (bouncesLeft == 0 || rho == 0.0) return direct;
    const Vector3 R = (-ray.direction).reflectIn(N);
    const Ray mirrored{P + N * kShadowBias, R};
    if (!scene.findClosestIntersection(mirrored)) return direct;  // nothing to reflect
    const ColourRGB reflected = trace(scene, mirrored, bouncesLeft - 1);
    return (1.0 - rho) * direct + rho * reflected;
    // TASK M4 end
}

}  // namespace raytracer
