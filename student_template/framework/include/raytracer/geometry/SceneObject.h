#ifndef RAYTRACER_GEOMETRY_SCENEOBJECT_H
#define RAYTRACER_GEOMETRY_SCENEOBJECT_H

#include <raytracer/geometry/Material.h>
#include <raytracer/geometry/RaycastHit.h>
#include <raytracer/math/Ray.h>

#include <optional>

namespace raytracer {

/// A surface that rays can hit. Never changes once built, so threads may share it.
class SceneObject {
public:
    virtual ~SceneObject() = default;
    SceneObject(const SceneObject&) = delete;
    SceneObject& operator=(const SceneObject&) = delete;

    /// The nearest hit in front of the ray's origin; empty when the ray misses.
    [[nodiscard]] virtual std::optional<RaycastHit> intersectionWith(const Ray& ray) const = 0;

    /// Unit normal for shading at `position`, a point of the surface in world space.
    [[nodiscard]] virtual Vector3 getNormalAt(const Vector3& position) const = 0;

    [[nodiscard]] const ColourRGB& colour() const { return material_.colour; }
    [[nodiscard]] double phongKD() const { return material_.phongKD; }
    [[nodiscard]] double phongKS() const { return material_.phongKS; }
    [[nodiscard]] double phongAlpha() const { return material_.phongAlpha; }
    [[nodiscard]] double reflectivity() const { return material_.reflectivity; }

protected:
    explicit SceneObject(const Material& material) : material_(material) {}

private:
    Material material_;
};

}  // namespace raytracer

#endif
