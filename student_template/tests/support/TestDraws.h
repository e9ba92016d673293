#ifndef SUPPORT_TESTDRAWS_H
#define SUPPORT_TESTDRAWS_H

#include <raytracer/math/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace raytracer::tests {

/// Random numbers for the tests' own questions, equal on every machine (splitmix64). The solution
/// draws from another generator.
class Draws {
public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}

    /// In [low, high).
    [[nodiscard]] double between(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11U) * 0x1p-53;
    }

    /// A unit vector, uniform over the sphere.
    [[nodiscard]] Vector3 direction() {
        const double y = between(-1.0, 1.0);
        const double angle = between(0.0, 2.0 * std::numbers::pi);
        const double ring = std::sqrt(std::max(0.0, 1.0 - y * y));
        return {ring * std::cos(angle), y, ring * std::sin(angle)};
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

}  // namespace raytracer::tests

#endif
