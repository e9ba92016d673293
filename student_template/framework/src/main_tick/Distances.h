#ifndef RAYTRACER_SRC_MAIN_TICK_DISTANCES_H
#define RAYTRACER_SRC_MAIN_TICK_DISTANCES_H

#include <raytracer/geometry/Sphere.h>
#include <raytracer/math/Ray.h>

#include <cmath>
#include <limits>

namespace raytracer {

/// Distance to the nearest point of the sphere in front of the origin, in lengths of the ray's
/// direction; infinite when the ray misses. From an origin inside, the distance to the far side.
[[nodiscard]] inline double distanceTo(const Sphere& sphere, const Ray& ray) {
    const Vector3 toCentre = sphere.centre() - ray.origin;
    const double a = ray.direction.dot(ray.direction);
    const double b = toCentre.dot(ray.direction);
    const double c = toCentre.dot(toCentre) - sphere.radius() * sphere.radius();
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
    const double root = std::sqrt(discriminant);
    if (b - root > 0.0) return (b - root) / a;
    if (b + root > 0.0) return (b + root) / a;
    return std::numeric_limits<double>::infinity();
}

/// Distance to the plane through `point` with `normal`, in lengths of the ray's direction; infinite
/// when it is not in front.
[[nodiscard]] inline double distanceTo(const Vector3& point, const Vector3& normal,
                                       const Ray& ray) {
    const double height = (point - ray.origin).dot(normal);
    const double slope = ray.direction.dot(normal);
    // Equal signs mean a hit in front: rays that miss skip the division.
    if (!(height * slope > 0.0)) return std::numeric_limits<double>::infinity();
    return height / slope;
}

}  // namespace raytracer

#endif
