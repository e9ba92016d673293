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
    const auto distanceBetween = [](const Vector3& a, const Vector3& b) {
        return (a - b).magnitude();
    };
    const Vector3 L = (light.position() - P).normalised();
    const Ray shadowRay{P + N * kShadowBias, L};
    if (const auto hit = scene.findClosestIntersection(shadowRay))
        return distanceBetween(hit->location, P) < distanceBetween(light.position(), P);
    return false;
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
    const double share = object.reflectivity();
    if (bouncesLeft > 0 && share > 0.0) {
        const Vector3 D = ray.direction;
        const Vector3 R = D - 2.0 * D.dot(N) * N;
        const ColourRGB seen = trace(scene, {P + kShadowBias * N, R}, bouncesLeft - 1);
        return direct + share * (seen - direct);
    }
    return direct;
    // TASK M4 end
}

}  // namespace raytracer
