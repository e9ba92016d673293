// Tasks M2, M3.2 and M4: Phong illumination, shadows and reflections.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace raytracer {
namespace {

// Whether something stands between the point P, whose surface has the normal N, and the light.
bool isShadowed(const Scene& scene, const PointLight& light, const Vector3& P, const Vector3& N) {
    // TASK M3.2 begin
    const Vector3 start = P + N * kShadowBias;
    const Vector3 toLight = light.position() - start;
    const std::optional<RaycastHit> hit =
        scene.findClosestIntersection(Ray{start, toLight.normalised()});
    return hit && hit->distance < toLight.magnitude();
    // TASK M3.2 end
}

}  // namespace

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    // TASK M2 begin
    // Mirroring the eye once is the same as mirroring every light: R.V = L.V', with V' = V mirrored
    // in N.
    const Vector3 mirroredV = (O - P).normalised().reflectIn(N);
    ColourRGB sum = scene.ambientLighting() * object.colour();
    for (const PointLight& light : scene.pointLights()) {
        if (isShadowed(scene, light, P, N)) continue;
        const Vector3 L = (light.position() - P).normalised();
        const double distance = (light.position() - P).magnitude();
        const double matt = object.phongKD() * std::clamp(N.dot(L), 0.0, 1.0);
        const double shiny = object.phongKS() *
                             std::pow(std::clamp(L.dot(mirroredV), 0.0, 1.0), object.phongAlpha());
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
    struct Layer {
        ColourRGB direct;
        double rho;
    };
    std::vector<Layer> layers{{direct, object.reflectivity()}};
    Ray path = ray;
    RaycastHit last = *hit;
    ColourRGB end;
    bool missed = false;
    while (bouncesLeft-- > 0 && layers.back().rho > 0.0 && !missed) {
        path =
            Ray{last.location + last.normal * kShadowBias, -path.direction.reflectIn(last.normal)};
        if (const auto next = scene.findClosestIntersection(path)) {
            last = *next;
            layers.push_back(
                {illuminate(scene, *last.object, last.location, last.normal, ray.origin),
                 last.object->reflectivity()});
        } else {
            missed = true;
        }
    }
    if (missed) {
        end = kBackgroundColour;
    } else {
        end = layers.back().direct;  // nothing is followed from here, so nothing is blended
        layers.pop_back();
    }
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
        end = (1.0 - layer->rho) * layer->direct + layer->rho * end;
    return end;
    // TASK M4 end
}

}  // namespace raytracer
