#include "FlatObjects.h"

#include <raytracer/scene/Scene.h>

namespace raytracer {

// Rays search for distances alone, by type of object; the full hit is built once, for the nearest
// one.
struct Scene::Fast {
    FlatSpheres spheres;
    FlatPlanes planes;
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
        fast_->spheres.add(*object);
        objects_.push_back(std::move(object));
    }
    for (const PlaneDescription& plane : description.planes) {
        auto object = std::make_unique<Plane>(plane.point, plane.normal, plane.material);
        fast_->planes.add(*object);
        objects_.push_back(std::move(object));
    }
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Nearest Scene::findNearest(const Ray& ray) const {
    return fast_->planes.nearest(ray, fast_->spheres.nearest(ray));
}

void Scene::tellObserver(Ray ray, std::optional<RaycastHit> hit) const {
    observer_->rayCast(ray, hit ? &*hit : nullptr);
}

}  // namespace raytracer
