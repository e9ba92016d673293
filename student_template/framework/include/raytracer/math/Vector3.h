#ifndef RAYTRACER_MATH_VECTOR3_H
#define RAYTRACER_MATH_VECTOR3_H

#include <cmath>

namespace raytracer {

/// A point or direction in the left-handed world: x to the right, y up, z away from the camera.
struct Vector3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    constexpr Vector3() = default;
    constexpr Vector3(double xValue, double yValue, double zValue)
        : x(xValue), y(yValue), z(zValue) {}

    [[nodiscard]] constexpr double dot(const Vector3& other) const {
        return x * other.x + y * other.y + z * other.z;
    }
    /// (y b.z - z b.y, z b.x - x b.z, x b.y - y b.x)
    [[nodiscard]] constexpr Vector3 cross(const Vector3& b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
    /// Length, in the units of the components.
    [[nodiscard]] double magnitude() const { return std::sqrt(dot(*this)); }
    /// The unit vector of the same direction; not finite for the zero vector.
    [[nodiscard]] Vector3 normalised() const {
        const double scale = 1.0 / magnitude();
        return {x * scale, y * scale, z * scale};
    }
    /// 2 (v.n) n - v: mirrors a vector that points away from the surface. `normal` has unit length.
    [[nodiscard]] constexpr Vector3 reflectIn(const Vector3& normal) const {
        const double twice = 2.0 * dot(normal);
        return {twice * normal.x - x, twice * normal.y - y, twice * normal.z - z};
    }

    /// A random point, uniform in the ball of radius 1 around the origin.
    /// Drawn from the calling thread's generator, see Random.h.
    [[nodiscard]] static Vector3 randomInsideUnitSphere();

    constexpr Vector3& operator+=(const Vector3& b) {
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
    constexpr Vector3& operator-=(const Vector3& b) {
        x -= b.x;
        y -= b.y;
        z -= b.z;
        return *this;
    }
    constexpr Vector3& operator*=(double scale) {
        x *= scale;
        y *= scale;
        z *= scale;
        return *this;
    }
    constexpr Vector3& operator/=(double divisor) {
        x /= divisor;
        y /= divisor;
        z /= divisor;
        return *this;
    }

    friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

[[nodiscard]] constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] constexpr Vector3 operator-(const Vector3& a) {
    return {-a.x, -a.y, -a.z};
}
[[nodiscard]] constexpr Vector3 operator*(const Vector3& a, double scale) {
    return {a.x * scale, a.y * scale, a.z * scale};
}
[[nodiscard]] constexpr Vector3 operator*(double scale, const Vector3& a) {
    return a * scale;
}
[[nodiscard]] constexpr Vector3 operator/(const Vector3& a, double divisor) {
    return {a.x / divisor, a.y / divisor, a.z / divisor};
}

}  // namespace raytracer

#endif
