#include <raytracer/math/Random.h>
#include <raytracer/math/Vector3.h>

#include <array>
#include <bit>
#include <cstddef>

namespace raytracer {
namespace {

/// xoshiro256+ (Blackman and Vigna 2018), seeded by splitmix64, with a small pool of ball points
/// that are made ahead: rejection without a branch costs a third of the usual loop.
class Generator {
public:
    explicit Generator(std::uint64_t seed) { restart(seed); }

    void restart(std::uint64_t seed) {
        for (std::uint64_t& word : state_) {
            seed += 0x9E3779B97F4A7C15U;
            std::uint64_t z = seed;
            z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
            z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
            word = z ^ (z >> 31U);
        }
        ready_ = 0;
    }

    /// In [0, 1).
    double uniform() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

    Vector3 ballPoint() {
        if (ready_ == 0) refill();
        return pool_[--ready_];
    }

private:
    static constexpr std::size_t kPoolSize = 64;

    std::uint64_t next() {
        const std::uint64_t result = state_[0] + state_[3];
        const std::uint64_t t = state_[1] << 17U;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = std::rotl(state_[3], 45);
        return result;
    }

    // A candidate is written in any case and kept by moving the end only if it lies in the ball.
    void refill() {
        std::size_t kept = 0;
        while (kept < kPoolSize) {
            const double x = 2.0 * uniform() - 1.0;
            const double y = 2.0 * uniform() - 1.0;
            const double z = 2.0 * uniform() - 1.0;
            pool_[kept] = {x, y, z};
            kept += static_cast<std::size_t>(x * x + y * y + z * z < 1.0);
        }
        ready_ = kept;
    }

    std::array<std::uint64_t, 4> state_{};
    std::array<Vector3, kPoolSize> pool_{};
    std::size_t ready_ = 0;
};

Generator& generator() {
    thread_local Generator instance{0};
    return instance;
}

}  // namespace

double randomBetween(double low, double high) {
    return low + (high - low) * generator().uniform();
}

void seedRandom(std::uint64_t seed) {
    generator().restart(seed);
}

Vector3 Vector3::randomInsideUnitSphere() {
    return generator().ballPoint();
}

}  // namespace raytracer
