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
    ColourRGB result = object.colour() * scene.ambientLighting();
    if (scene.pointLights().empty()) return result;
    for (const PointLight& light : scene.pointLights()) {
        Vector3 L = light.position() - P;
        const double d = L.magnitude();
        L /= d;
        const double cosine = N.dot(L);
        if (cosine <= 0.0) continue;  // the light is behind the surface
        if (isShadowed(scene, light, P, N)) continue;
        ColourRGB reflected = object.colour();
        reflected *= object.phongKD() * cosine;
        const double gloss = std::max(0.0, L.reflectIn(N).dot((O - P).normalised()));
        reflected += light.colour() * (object.phongKS() * std::pow(gloss, object.phongAlpha()));
        result += reflected * light.illuminationAt(d);
    }
    return result;
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
    if (rho <= 0.0) return direct;
    if (bouncesLeft <= 0) return direct;
    const auto mirrorColour = [&] {
        const Vector3 towardsViewer = -ray.direction;
        return trace(scene, Ray{P + N * kShadowBias, towardsViewer.reflectIn(N)}, bouncesLeft - 1);
    };
    if (rho >= 1.0) return mirrorColour();
    ColourRGB blended = direct * (1.0 - rho);
    blended += mirrorColour() * rho;
    return blended;
    // TASK M4 end
}

}  // namespace raytracer
