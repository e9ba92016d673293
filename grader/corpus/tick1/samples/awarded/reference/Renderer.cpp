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
    const Vector3 path = light.position() - P;
    const Ray shadowRay{P + N * kShadowBias, path.normalised()};
    const std::optional<RaycastHit> occluder = scene.findClosestIntersection(shadowRay);
    return occluder && occluder->distance < path.magnitude();
    // TASK M3.2 end
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK M2 begin
    const Vector3 V = (O - P).normalised();
    ColourRGB colour = object.colour() * scene.ambientLighting();
    for (const PointLight& light : scene.pointLights()) {
        if (isShadowed(scene, light, P, N)) continue;
        const Vector3 path = light.position() - P;
        const Vector3 L = path.normalised();
        const Vector3 R = L.reflectIn(N);
        const ColourRGB I = light.illuminationAt(path.magnitude());
        colour += object.colour() * I * (object.phongKD() * std::max(0.0, N.dot(L)));
        colour += light.colour() * I *
                  (object.phongKS() * std::pow(std::max(0.0, R.dot(V)), object.phongAlpha()));
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
    if (bouncesLeft == 0 || share == 0.0) return direct;
    const Vector3 R = (-ray.direction).reflectIn(N);
    const Ray reflected{P + N * kShadowBias, R};
    return direct * (1.0 - share) + trace(scene, reflected, bouncesLeft - 1) * share;
    // TASK M4 end
}

}  // namespace raytracer
