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
    // R.V = (2 (N.L) N - L).V = 2 (N.L)(N.V) - L.V, so that R is not needed.
    const Vector3 V = (O - P).normalised();
    const double NV = N.dot(V);
    ColourRGB diffuse, specular;
    for (const PointLight& light : scene.pointLights()) {
        if (isShadowed(scene, light, P, N)) continue;
        const Vector3 way = light.position() - P;
        const double d = way.magnitude();
        const Vector3 L = way / d;
        const double NL = N.dot(L);
        const double RV = 2.0 * NL * NV - L.dot(V);
        const ColourRGB I = light.illuminationAt(d);
        if (NL > 0.0) diffuse += I * NL;
        specular += I * light.colour() * std::pow(std::max(RV, 0.0), object.phongAlpha());
    }
    return object.colour() * (scene.ambientLighting() + object.phongKD() * diffuse) + object.phongKS() * specular;
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
