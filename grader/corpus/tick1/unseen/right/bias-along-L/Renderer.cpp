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
    const Vector3 difference = light.position() - P;
    const double d = difference.magnitude();
    const Vector3 L = difference / d;
    if (N.dot(L) <= 0.0) return true;  // the surface itself stands between
    const Ray ray{P + L * kShadowBias, L};
    const auto hit = scene.findClosestIntersection(ray);
    if (!hit) return false;
    return hit->distance + kShadowBias < d;
    // TASK M3.2 end
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK M2 begin
    // Mirroring the eye once is the same as mirroring every light: R.V = L.V', with V' = V mirrored in N.
    const Vector3 mirroredV = (O - P).normalised().reflectIn(N);
    ColourRGB sum = scene.ambientLighting() * object.colour();
    for (const PointLight& light : scene.pointLights()) {
        if (isShadowed(scene, light, P, N)) continue;
        const Vector3 L = (light.position() - P).normalised();
        const double distance = (light.position() - P).magnitude();
        const double matt = object.phongKD() * std::clamp(N.dot(L), 0.0, 1.0);
        const double shiny = object.phongKS() * std::pow(std::clamp(L.dot(mirroredV), 0.0, 1.0), object.phongAlpha());
        sum += (object.colour() * matt + light.colour() * shiny) * light.illuminationAt(distance);
    }
    return sum;
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
