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
    // Copied component by component: loading pairs that were just computed would stall.
    constexpr Ray(const Vector3& from, const Vector3& towards)
        : origin(from.x, from.y, from.z), direction(towards.x, towards.y, towards.z) {}

    /// The point origin + distance * direction.
    [[nodiscard]] constexpr Vector3 evaluateAt(double distance) const {
        return origin + direction * distance;
    }
};

}  // namespace raytracer

#endif
