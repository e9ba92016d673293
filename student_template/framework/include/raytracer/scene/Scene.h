#ifndef RAYTRACER_SCENE_SCENE_H
#define RAYTRACER_SCENE_SCENE_H

#include <raytracer/base/RenderObserver.h>
#include <raytracer/geometry/BumpySphere.h>
#include <raytracer/geometry/Plane.h>
#include <raytracer/geometry/Sphere.h>
#include <raytracer/math/Ray.h>
#include <raytracer/scene/Nearest.h>
#include <raytracer/scene/PointLight.h>
#include <raytracer/scene/SceneDescription.h>

#include <memory>
#include <optional>
#include <vector>

namespace raytracer {

/// All objects and lights. Never changes once built, so threads may share it.
class Scene {
public:
    /// @param observer  Receives every ray that is cast; not owned; null: no observer.
    explicit Scene(const SceneDescription& description, RenderObserver* observer = nullptr);
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// The first surface that the ray meets in front of its origin; empty when it meets none.
    ///
    /// Inline, so that a caller that needs only the distance does not pay for location and normal.
    [[nodiscard]] std::optional<RaycastHit> findClosestIntersection(const Ray& ray) const {
        std::optional<RaycastHit> hit = findNearest(ray).hitOf(ray);
        if (observer_ != nullptr) tellObserver(ray, hit);
        return hit;
    }

    [[nodiscard]] const std::vector<PointLight>& pointLights() const { return pointLights_; }
    [[nodiscard]] const ColourRGB& ambientLighting() const { return ambientLighting_; }

    /// The spheres, then the planes, each in the order of the scene file.
    [[nodiscard]] const std::vector<std::unique_ptr<SceneObject>>& objects() const {
        return objects_;
    }

private:
    struct Fast;  // a copy of the objects in a layout for fast intersection

    [[nodiscard]] Nearest findNearest(const Ray& ray) const;
    // By value: passing addresses would force the hit into memory even without an observer.
    void tellObserver(Ray ray, std::optional<RaycastHit> hit) const;

    ColourRGB ambientLighting_;
    std::vector<PointLight> pointLights_;
    std::vector<std::unique_ptr<SceneObject>> objects_;
    std::unique_ptr<Fast> fast_;
    RenderObserver* observer_;
};

}  // namespace raytracer

#endif
