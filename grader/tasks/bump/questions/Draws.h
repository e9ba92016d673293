#ifndef TICKER_TASKS_BUMP_DRAWS_H
#define TICKER_TASKS_BUMP_DRAWS_H

#include <grader/base/SplitMix.h>

#include <raytracer/math/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace ticker::tasks::bump {

using raytracer::Vector3;

/// Unit vector at a longitude (0 towards the camera, growing to the right, +x) and a polar angle
/// (from +y), both in radians.
[[nodiscard]] inline Vector3 directionAt(double longitude, double polarAngle) {
    const double ring = std::sin(polarAngle);
    return {ring * std::sin(longitude), std::cos(polarAngle), -ring * std::cos(longitude)};
}

/// Random numbers of the hidden questions. Equal seeds give equal draws on every machine
/// (splitmix64; the standard library's distributions may differ between systems).
class Draws {
public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}

    /// In [low, high).
    [[nodiscard]] double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(splitMix(state_) >> 11U) * 0x1p-53;
    }

    /// In [low, high], both included.
    [[nodiscard]] int integer(int low, int high) {
        return low +
               static_cast<int>(splitMix(state_) % static_cast<std::uint64_t>(high - low + 1));
    }

    /// A unit vector, uniform over the sphere.
    [[nodiscard]] Vector3 direction() {
        const double y = uniform(-1.0, 1.0);
        const double longitude = uniform(0.0, 2.0 * std::numbers::pi);
        const double ring = std::sqrt(std::max(0.0, 1.0 - y * y));
        return Vector3{ring * std::sin(longitude), y, -ring * std::cos(longitude)}.normalised();
    }

    /// `count` unit vectors, each uniform over the sphere.
    [[nodiscard]] std::vector<Vector3> directions(int count) {
        std::vector<Vector3> drawn;
        drawn.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            drawn.push_back(direction());
        return drawn;
    }

private:
    std::uint64_t state_;
};

}  // namespace ticker::tasks::bump

#endif
