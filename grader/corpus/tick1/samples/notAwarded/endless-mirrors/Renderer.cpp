#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

ColourRGB Renderer::illuminate(const Scene& scene, const SceneObject& object, const Vector3& P,
                               const Vector3& N, const Vector3& O) const {
    ColourRGB colour = object.colour() * scene.ambientLighting();
    Vector3 V = (O - P).normalised();
    for (const auto& light : scene.pointLights()) {
        double d = (light.position() - P).magnitude();
        Vector3 L = (light.position() - P) / d;
        auto hit = scene.findClosestIntersection({P + N * kShadowBias, L});
        if (hit && hit->distance < d) continue;
        ColourRGB I = light.illuminationAt(d);
        double nl = std::max(0.0, N.dot(L)), rv = std::max(0.0, L.reflectIn(N).dot(V));
        colour += object.colour() * I * (object.phongKD() * nl);
        colour += light.colour() * I * (object.phongKS() * std::pow(rv, object.phongAlpha()));
    }
    return colour;
}

ColourRGB Renderer::trace(const Scene& scene, const Ray& ray, int bouncesLeft) const {
    auto hit = scene.findClosestIntersection(ray);
    if (!hit) return kBackgroundColour;
    ColourRGB direct = illuminate(scene, *hit->object, hit->location, hit->normal, ray.origin);
    double k = hit->object->reflectivity();
    if (bouncesLeft == 0 || k == 0) return direct;
    Ray next{hit->location + hit->normal * kShadowBias, (-ray.direction).reflectIn(hit->normal)};
    return direct * (1 - k) + trace(scene, next, bouncesLeft) * k;
}

}  // namespace raytracer
