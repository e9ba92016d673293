#include <raytracer/scene/Scene.h>

#include <limits>

namespace raytracer {

// Rays ask for distances alone, by type; the hit is built once, for the nearest surface.
struct Scene::Fast {
    std::vector<const Sphere*> spheres;
    std::vector<const Plane*> planes;
};

Scene::Scene(const SceneDescription& description, RenderObserver* observer)
    : ambientLighting_(description.ambientLighting),
      pointLights_(description.pointLights),
      fast_(std::make_unique<Fast>()),
      observer_(observer) {
    for (const SphereDescription& sphere : description.spheres) {
        std::unique_ptr<Sphere> object;
        if (sphere.heightMap != nullptr)
            object = std::make_unique<BumpySphere>(sphere.centre, sphere.radius, sphere.material,
                                                   sphere.heightMap);
        else
            object = std::make_unique<Sphere>(sphere.centre, sphere.radius, sphere.material);
        fast_->spheres.push_back(object.get());
        objects_.push_back(std::move(object));
    }
    for (const PlaneDescription& plane : description.planes) {
        auto object = std::make_unique<Plane>(plane.point, plane.normal, plane.material);
        fast_->planes.push_back(object.get());
        objects_.push_back(std::move(object));
    }
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

std::optional<RaycastHit> Scene::findClosestIntersection(const Ray& ray) const {
    std::optional<RaycastHit> hit = closest(ray);
    if (observer_ != nullptr) observer_->rayCast(ray, hit ? &*hit : nullptr);
    return hit;
}

std::optional<RaycastHit> Scene::closest(const Ray& ray) const {
    double nearest = std::numeric_limits<double>::infinity();
    const SceneObject* object = nullptr;
    for (const Sphere* sphere : fast_->spheres) {
        const double distance = sphere->distanceAlong(ray);
        if (distance < nearest) {
            nearest = distance;
            object = sphere;
        }
    }
    for (const Plane* plane : fast_->planes) {
        const double distance = plane->distanceAlong(ray);
        if (distance < nearest) {
            nearest = distance;
            object = plane;
        }
    }
    if (object == nullptr) return std::nullopt;
    const Vector3 location = ray.evaluateAt(nearest);
    return RaycastHit{object, nearest, location, object->getNormalAt(location)};
}

}  // namespace raytracer
