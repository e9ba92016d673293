#ifndef RAYTRACER_GEOMETRY_SPHERE_H
#define RAYTRACER_GEOMETRY_SPHERE_H

#include <raytracer/geometry/SceneObject.h>

namespace raytracer {

/// A smooth sphere.
class Sphere : public SceneObject {
public:
    /// @param radius  World units, positive.
    Sphere(const Vector3& centre, double radius, const Material& material)
        : SceneObject(material), centre_(centre), radius_(radius) {}

    [[nodiscard]] const Vector3& centre() const { return centre_; }
    [[nodiscard]] double radius() const { return radius_; }

    /// The nearest point of the sphere in front of the ray's origin; from inside, the point on the
    /// far side. Main tick: task M1, in exercise/Sphere.cpp; given in the starred exercise.
    [[nodiscard]] std::optional<RaycastHit> intersectionWith(const Ray& ray) const override;
    /// Unit normal, world space, pointing away from the centre.
    /// @param position  Any point but the centre, world space.
    [[nodiscard]] Vector3 getNormalAt(const Vector3& position) const override {
        return (position - centre_).normalised();
    }

private:
    Vector3 centre_;
    double radius_;
};

}  // namespace raytracer

#endif
