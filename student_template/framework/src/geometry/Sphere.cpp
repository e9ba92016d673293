#include <raytracer/geometry/Sphere.h>

#include <cmath>

namespace raytracer {

double Sphere::distanceAlong(const Ray& ray) const {
    const Vector3 toCentre = centre_ - ray.origin;
    const double a = ray.direction.dot(ray.direction);
    const double b = toCentre.dot(ray.direction);
    const double discriminant = b * b - a * (toCentre.dot(toCentre) - radius_ * radius_);
    if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
    const double root = std::sqrt(discriminant);
    if (b - root > 0.0) return (b - root) / a;
    if (b + root > 0.0) return (b + root) / a;
    return std::numeric_limits<double>::infinity();
}

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    const double distance = distanceAlong(ray);
    if (std::isinf(distance)) return std::nullopt;
    const Vector3 location = ray.evaluateAt(distance);
    return RaycastHit{this, distance, location, getNormalAt(location)};
}

Vector3 Sphere::getNormalAt(const Vector3& position) const {
    return (position - centre_).normalised();
}

}  // namespace raytracer
