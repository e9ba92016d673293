#ifndef RAYTRACER_MATH_RAY_H
#define RAYTRACER_MATH_RAY_H

#include <raytracer/math/Vector3.h>

namespace raytracer {

/// A half-line. Distances along it are counted in lengths of `direction`, so they are world units
/// when the direction has unit length; any other finite length works as well.
struct Ray {
    Vector3 origin;
    Vector3 direction;

    /// The point origin + distance * direction.
    [[nodiscard]] constexpr Vector3 evaluateAt(double distance) const {
        return origin + direction * distance;
    }
};

}  // namespace raytracer

#endif
