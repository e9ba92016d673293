// Tasks M2, M3.2 and M4: Phong illumination, shadows and reflections.
// Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

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
        path = Ray{last.location + last.normal * kShadowBias, -path.direction.reflectIn(last.normal)};
        if (const auto next = scene.findClosestIntersection(path)) {
            last = *next;
            layers.push_back({illuminate(scene, *last.object, last.location, last.normal, path.origin),
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
