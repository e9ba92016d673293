#ifndef RAYTRACER_GEOMETRY_PLANE_H
#define RAYTRACER_GEOMETRY_PLANE_H

#include <raytracer/geometry/SceneObject.h>

namespace raytracer {

/// An infinite plane. Its normal points to one side; lights on the other side add nothing, wherever
/// it is seen from.
class Plane final : public SceneObject {
public:
    /// @param point   Any point of the plane, world space.
    /// @param normal  Any length but zero; it is normalised.
    Plane(const Vector3& point, const Vector3& normal, const Material& material)
        : SceneObject(material), point_(point), normal_(normal.normalised()) {}

    [[nodiscard]] const Vector3& point() const { return point_; }
    [[nodiscard]] const Vector3& normal() const { return normal_; }

    /// The point where the ray meets the plane, from either side. Main tick: task M3.1, in
    /// exercise/Plane.cpp; given in the starred exercise.
    [[nodiscard]] std::optional<RaycastHit> intersectionWith(const Ray& ray) const override;
    /// Unit normal, world space; the same at every position.
    [[nodiscard]] Vector3 getNormalAt(const Vector3& /*position*/) const override {
        return normal_;
    }

private:
    Vector3 point_;
    Vector3 normal_;
};

}  // namespace raytracer

#endif
