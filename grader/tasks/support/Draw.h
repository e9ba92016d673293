#ifndef TICKER_TASKS_SUPPORT_DRAW_H
#define TICKER_TASKS_SUPPORT_DRAW_H

#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>

#include <cstdint>

namespace ticker::tasks {

using raytracer::ColourRGB;
using raytracer::Vector3;

/// Random numbers of the hidden questions: splitmix64 (Steele, Lea and Flood 2014). Equal seeds
/// give equal questions on every machine, which the standard library's distributions do not
/// guarantee.
class Draw {
public:
    /// @param purpose  Different purposes give independent draws from one seed.
    Draw(std::uint64_t seed, std::uint64_t purpose);

    [[nodiscard]] std::uint64_t word();
    /// In [low, high).
    [[nodiscard]] double between(double low, double high);
    /// In [low, high], both included.
    [[nodiscard]] int whole(int low, int high);
    /// A unit vector, uniform over the sphere.
    [[nodiscard]] Vector3 direction();
    /// A unit vector at an angle in [0, maxAngle) of `axis` (unit), uniform in the angle.
    [[nodiscard]] Vector3 directionAround(const Vector3& axis, double maxAngle);
    /// Each channel in [low, high), independent.
    [[nodiscard]] ColourRGB colour(double low, double high);

private:
    std::uint64_t state_;
};

/// Two unit vectors that are at right angles to `axis` (unit) and to each other.
struct Perpendiculars {
    Vector3 first;
    Vector3 second;
};
[[nodiscard]] Perpendiculars perpendicularsOf(const Vector3& axis);

}  // namespace ticker::tasks

#endif
