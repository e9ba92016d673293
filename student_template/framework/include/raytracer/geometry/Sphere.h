#ifndef RAYTRACER_GEOMETRY_SPHERE_H
#define RAYTRACER_GEOMETRY_SPHERE_H

#include <raytracer/geometry/SceneObject.h>

#include <cmath>
#include <limits>

namespace raytracer {

/// A smooth sphere.
class Sphere : public SceneObject {
public:
    /// @param radius  World units, positive.
    Sphere(const Vector3& centre, double radius, const Material& material)
        : SceneObject(material), centre_(centre), radius_(radius) {}

    [[nodiscard]] const Vector3& centre() const { return centre_; }
    [[nodiscard]] double radius() const { return radius_; }

    /// Distance to the nearest point of the sphere in front of the origin, in lengths of the ray's
    /// direction; infinite when the ray misses. An origin inside sees the far side.
    [[nodiscard]] double distanceAlong(const Ray& ray) const {
        const Vector3 toCentre = centre_ - ray.origin;
        const double a = ray.direction.dot(ray.direction);
        const double b = toCentre.dot(ray.direction);
        const double c = toCentre.dot(toCentre) - radius_ * radius_;
        const double discriminant = b * b - a * c;
        if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
        const double root = std::sqrt(discriminant);
        if (b - root > 0.0) return (b - root) / a;
        if (b + root > 0.0) return (b + root) / a;
        return std::numeric_limits<double>::infinity();
    }

    [[nodiscard]] std::optional<RaycastHit> intersectionWith(const Ray& ray) const override;
    /// Away from the centre.
    [[nodiscard]] Vector3 getNormalAt(const Vector3& position) const override {
        return (position - centre_).normalised();
    }

private:
    Vector3 centre_;
    double radius_;
};

}  // namespace raytracer

#endif
