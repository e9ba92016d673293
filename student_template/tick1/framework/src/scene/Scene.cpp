#include <raytracer/scene/Scene.h>

#include <limits>

namespace raytracer {

struct Scene::Fast {};

Scene::Scene(const SceneDescription& description, RenderObserver* observer)
    : ambientLighting_(description.ambientLighting),
      pointLights_(description.pointLights),
      observer_(observer) {
    for (const SphereDescription& sphere : description.spheres)
        objects_.push_back(std::make_unique<Sphere>(sphere.centre, sphere.radius, sphere.material));
    for (const PlaneDescription& plane : description.planes)
        objects_.push_back(std::make_unique<Plane>(plane.point, plane.normal, plane.material));
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

// A distance that is no number is never nearer.
Nearest Scene::findNearest(const Ray& ray) const {
    Nearest nearest;
    for (const auto& object : objects_) {
        const std::optional<RaycastHit> hit = object->intersectionWith(ray);
        const double farthest =
            nearest.hit ? nearest.hit->distance : std::numeric_limits<double>::infinity();
        if (hit && hit->distance < farthest) nearest.hit = hit;
    }
    return nearest;
}

void Scene::tellObserver(Ray ray, std::optional<RaycastHit> hit) const {
    observer_->rayCast(ray, hit ? &*hit : nullptr);
}

}  // namespace raytracer
