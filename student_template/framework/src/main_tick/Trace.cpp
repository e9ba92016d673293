#include <raytracer/base/RenderObserver.h>
#include <raytracer/render/Renderer.h>

namespace raytracer {

ColourRGB Renderer::trace(const Scene& scene, const Ray& ray, int bouncesLeft) const {
    RenderObserver* observer = settings_.observer;
    if (observer != nullptr) observer->traceBegan(ray, bouncesLeft);

    ColourRGB colour = kBackgroundColour;
    if (const std::optional<RaycastHit> hit = scene.findClosestIntersection(ray)) {
        const SceneObject& object = *hit->object;
        if (observer != nullptr)
            observer->illuminateBegan(object, hit->location, hit->normal, ray.origin);
        colour = illuminate(scene, object, hit->location, hit->normal, ray.origin);
        if (observer != nullptr) observer->illuminateEnded(colour);

        const double share = object.reflectivity();
        if (bouncesLeft > 0 && share > 0.0) {
            const Vector3 mirrored = (-ray.direction).reflectIn(hit->normal);
            const Ray reflected{hit->location + hit->normal * kShadowBias, mirrored};
            colour = colour * (1.0 - share) + trace(scene, reflected, bouncesLeft - 1) * share;
        }
    }

    if (observer != nullptr) observer->traceEnded(colour);
    return colour;
}

}  // namespace raytracer
