// Tasks M2, M3.2 and M4: Phong illumination, shadows and reflections.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace raytracer {
namespace {

// Whether something stands between the point P, whose surface has the normal N, and the light.
bool isShadowed(const Scene& scene, const PointLight& light, const Vector3& P, const Vector3& N) {
    // TASK M3.2 begin
    const Vector3 toLight = light.position() - P;
    const Vector3 start = P + kShadowBias * N;
    const auto blocker = scene.findClosestIntersection({start, toLight.normalised()});
    if (!blocker) return false;
    const Vector3 toBlocker = blocker->location - start;
    return toBlocker.dot(toBlocker) < toLight.dot(toLight);
    // TASK M3.2 end
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK M2 begin
    ColourRGB colour = object.colour() * scene.ambientLighting();
    const Vector3 V = (O - P).normalised();
    for (const PointLight& light : scene.pointLights()) {
        if (isShadowed(scene, light, P, N)) continue;
        const Vector3 toLight = light.position() - P;
        const Vector3 L = toLight.normalised();
        const Vector3 R = L.reflectIn(N);
        const ColourRGB I = light.illuminationAt(toLight.magnitude());
        const double NdotL = std::max(0.0, N.dot(L));
        const double RdotV = std::max(0.0, R.dot(V));
        colour += object.colour() * object.phongKD() * I * NdotL;
        colour += light.colour() * object.phongKS() * I * std::pow(RdotV, object.phongAlpha());
    }
    return colour;
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
    ColourRGB sum;
    ColourRGB here = direct;
    double weight = 1.0;  // of what the current ray sees, in the final colour
    Ray current = ray;
    RaycastHit at = *hit;
    for (int left = bouncesLeft;; --left) {
        const double rho = at.object->reflectivity();
        if (left <= 0 || rho == 0.0) return sum + weight * here;
        sum += weight * (1.0 - rho) * here;
        weight = rho;
        current = Ray{at.location + at.normal * kShadowBias, (-current.direction).reflectIn(at.normal)};
        const auto next = scene.findClosestIntersection(current);
        if (!next) return sum + weight * kBackgroundColour;
        at = *next;
        here = illuminate(scene, *at.object, at.location, at.normal, current.origin);
    }
    // TASK M4 end
}

}  // namespace raytracer
