#ifndef RAYTRACER_MATH_RAY_H
#define RAYTRACER_MATH_RAY_H

#include <raytracer/math/Vector3.h>

namespace raytracer {

/// A half-line. Distances along it are counted in lengths of `direction`, so they are world units
/// when the direction has unit length; any other finite length works as well.
struct Ray {
    Vector3 origin;
    Vector3 direction;

    constexpr Ray() = default;
    // Component by component: the compiler would copy a whole Vector3 by 16-byte loads, which stall
    // while its components are still being stored one by one.
    constexpr Ray(const Vector3& from, const Vector3& towards)
        : origin(from.x, from.y, from.z), direction(towards.x, towards.y, towards.z) {}

    /// The point origin + distance * direction.
    [[nodiscard]] constexpr Vector3 evaluateAt(double distance) const {
        return origin + direction * distance;
    }
};

}  // namespace raytracer

#endif
