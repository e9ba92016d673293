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
    unfinished("M3.2", "cast a ray from a little above P to the light; until then all is lit");
    std::ignore = std::tie(scene, light, P, N);
    return false;
    // TASK M3.2 end
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK M2 begin
    unfinished("M2", "add up ambient, diffuse and specular light; until then colours are flat");
    for (const PointLight& light : scene.pointLights()) {
        if (isShadowed(scene, light, P, N)) continue;
        // Here: diffuse and specular light of this point light, seen from O.
        std::ignore = O;
    }
    return object.colour();
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
    unfinished("M4", "follow the mirrored ray; until then nothing is a mirror");
    std::ignore = bouncesLeft;
    return direct;
    // TASK M4 end
}

}  // namespace raytracer
