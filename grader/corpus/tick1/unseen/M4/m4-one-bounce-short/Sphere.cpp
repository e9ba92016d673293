// Task M1: where a ray meets a sphere. Fill in what stands between the TASK marks.
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/Sphere.h>

#include <algorithm>
#include <cmath>

namespace raytracer {

std::optional<RaycastHit> Sphere::intersectionWith(const Ray& ray) const {
    // TASK M1 begin
    const Vector3 toCentre = centre() - ray.origin;
    const double along = toCentre.dot(ray.direction);
    const Vector3 off = ray.evaluateAt(along) - centre();  // from the centre to the nearest point of the line
    const double offSquared = off.dot(off);
    const double radiusSquared = radius() * radius();
    if (offSquared > radiusSquared) return std::nullopt;
    const double halfChord = std::sqrt(radiusSquared - offSquared);

    double s = along - halfChord;
    if (s <= 0.0) s = along + halfChord;
    if (s <= 0.0) return std::nullopt;
    const Vector3 location = ray.evaluateAt(s);
    return RaycastHit{this, s, location, getNormalAt(location)};
    // TASK M1 end
}

}  // namespace raytracer
