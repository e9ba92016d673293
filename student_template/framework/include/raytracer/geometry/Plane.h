#ifndef RAYTRACER_GEOMETRY_PLANE_H
#define RAYTRACER_GEOMETRY_PLANE_H

#include <raytracer/geometry/SceneObject.h>

#include <limits>

namespace raytracer {

/// An infinite plane. Its normal points to one side; on the other side only ambient light is
/// visible.
class Plane final : public SceneObject {
public:
    /// @param point   Any point of the plane, world space.
    /// @param normal  Any length but zero; it is normalised.
    Plane(const Vector3& point, const Vector3& normal, const Material& material)
        : SceneObject(material), point_(point), normal_(normal.normalised()) {}

    [[nodiscard]] const Vector3& point() const { return point_; }
    [[nodiscard]] const Vector3& normal() const { return normal_; }

    /// Distance to the plane in lengths of the ray's direction; infinite when it is not in front.
    [[nodiscard]] double distanceAlong(const Ray& ray) const {
        return distanceAlong(ray, point_, normal_);
    }

    /// The same for the plane through `point` with `normal`.
    [[nodiscard]] static double distanceAlong(const Ray& ray, const Vector3& point,
                                              const Vector3& normal) {
        const double height = (point - ray.origin).dot(normal);
        const double slope = ray.direction.dot(normal);
        // Equal signs mean a hit in front: rays that miss skip the division.
        if (!(height * slope > 0.0)) return std::numeric_limits<double>::infinity();
        return height / slope;
    }

    [[nodiscard]] std::optional<RaycastHit> intersectionWith(const Ray& ray) const override;
    [[nodiscard]] Vector3 getNormalAt(const Vector3& position) const override;

private:
    Vector3 point_;
    Vector3 normal_;
};

}  // namespace raytracer

#endif
