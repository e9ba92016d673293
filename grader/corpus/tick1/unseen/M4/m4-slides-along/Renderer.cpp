// Tasks M2, M3.2 and M4: Phong illumination, shadows and reflections.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
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
    const auto positive = [](double x) { return x > 0.0 ? x : 0.0; };
    const Vector3 V = (O - P).normalised();
    const auto contribution = [&](const PointLight& light) {
        const Vector3 L = (light.position() - P).normalised();
        const ColourRGB arriving = light.illuminationAt((light.position() - P).magnitude());
        const ColourRGB diffuse = object.colour() * (object.phongKD() * positive(N.dot(L)));
        const ColourRGB specular =
            light.colour() * (object.phongKS() * std::pow(positive(L.reflectIn(N).dot(V)), object.phongAlpha()));
        return (diffuse + specular) * arriving;
    };
    const auto& lights = scene.pointLights();
    return std::accumulate(lights.begin(), lights.end(), object.colour() * scene.ambientLighting(),
                           [&](const ColourRGB& sum, const PointLight& light) {
                               return isShadowed(scene, light, P, N) ? sum : sum + contribution(light);
                           });
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
        const Vector3 R = (ray.direction - ray.direction.dot(N) * N).normalised();
        return trace(scene, Ray{P + N * kShadowBias, R}, bouncesLeft - 1);
    };
    if (rho >= 1.0) return mirrorColour();
    ColourRGB blended = direct * (1.0 - rho);
    blended += mirrorColour() * rho;
    return blended;
    // TASK M4 end
}

}  // namespace raytracer
