#ifndef TICKER_TASKS_BUMP_DRAWS_H
#define TICKER_TASKS_BUMP_DRAWS_H

#include <raytracer/math/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace ticker::tasks::bump {

using raytracer::Vector3;

/// Where the hidden questions come from: equal seeds give equal draws on every machine
/// (splitmix64; the standard library's distributions may differ between systems).
class Draws {
public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}

    /// In [low, high).
    [[nodiscard]] double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11U) * 0x1p-53;
    }

    /// In [low, high], both included.
    [[nodiscard]] int integer(int low, int high) {
        return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
    }

    /// A unit vector, uniform over the sphere.
    [[nodiscard]] Vector3 direction() {
        const double y = uniform(-1.0, 1.0);
        const double longitude = uniform(0.0, 2.0 * std::numbers::pi);
        const double ring = std::sqrt(std::max(0.0, 1.0 - y * y));
        return Vector3{ring * std::sin(longitude), y, -ring * std::cos(longitude)}.normalised();
    }

    /// So many unit vectors.
    [[nodiscard]] std::vector<Vector3> directions(int count) {
        std::vector<Vector3> drawn;
        drawn.reserve(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i)
            drawn.push_back(direction());
        return drawn;
    }

private:
    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
};

}  // namespace ticker::tasks::bump

#endif
