#include <raytracer/math/Random.h>
#include <raytracer/math/Vector3.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>

namespace raytracer {
namespace {

/// xoshiro256++ (Blackman and Vigna 2018), seeded by splitmix64.
class Generator {
public:
    /// True until the first `restart`: no seed gives a state of all zeros.
    [[nodiscard]] bool isBlank() const {
        return (state_[0] | state_[1] | state_[2] | state_[3]) == 0;
    }

    void restart(std::uint64_t seed) {
        for (std::uint64_t& word : state_) {
            seed += 0x9E3779B97F4A7C15U;
            std::uint64_t z = seed;
            z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
            z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
            word = z ^ (z >> 31U);
        }
    }

    std::uint64_t next() {
        const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
        const std::uint64_t t = state_[1] << 17U;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = std::rotl(state_[3], 45);
        return result;
    }

private:
    std::array<std::uint64_t, 4> state_{};
};

// constinit: initialised at compile time, so that no draw checks for initialisation.
constinit thread_local Generator generator;

/// The thread's generator. A thread that was not seeded gets a stream of its own: two threads with
/// the same numbers would leave a visible pattern in the picture.
Generator& seededGenerator() {
    static constinit std::atomic<std::uint64_t> threadsSeen{0};
    if (generator.isBlank()) generator.restart(threadsSeen++);
    return generator;
}

/// Interprets one draw as a cell of a cube with 2^21 cells on a side; the unit ball is inscribed in
/// the cube.
struct Cell {
    std::int64_t x;
    std::int64_t y;
    std::int64_t z;

    // 21 bits each, signed: shifting left first removes the other bits.
    explicit Cell(std::uint64_t bits)
        : x(static_cast<std::int64_t>(bits << 43U) >> 43U),
          y(static_cast<std::int64_t>(bits << 22U) >> 43U),
          z(static_cast<std::int64_t>(bits << 1U) >> 43U) {}

    /// Whether the cell's centre (x + 1/2, y + 1/2, z + 1/2) is less than 2^20 from the origin.
    [[nodiscard]] bool isInBall() const {
        constexpr std::int64_t kRadiusSquared = std::int64_t{1} << 40U;
        return x * (x + 1) + y * (y + 1) + z * (z + 1) < kRadiusSquared;
    }

    /// The cell's centre, scaled to the unit ball.
    [[nodiscard]] Vector3 middle() const { return {scaled(x), scaled(y), scaled(z)}; }

private:
    static double scaled(std::int64_t place) {
        return static_cast<double>(static_cast<std::int32_t>(place)) * 0x1p-20 + 0x1p-21;
    }
};

/// Cells of the unit ball, drawn in batches: rejection without branches takes a third of the time
/// of the usual loop.
class BallCells {
public:
    void clear() { ready_ = 0; }

    Cell take() {
        if (ready_ == 0) refill();
        return Cell{draws_[--ready_]};
    }

private:
    static constexpr std::size_t kCount = 64;

    // Every candidate is written; the end moves past it only if it lies in the ball.
    [[gnu::noinline]] void refill() {
        Generator local = seededGenerator();  // a local copy, so that it stays in registers
        std::size_t kept = 0;
        while (kept < kCount) {
            const std::uint64_t draw = local.next();
            draws_[kept] = draw;
            kept += static_cast<std::size_t>(Cell{draw}.isInBall());
        }
        generator = local;
        ready_ = kept;
    }

    std::array<std::uint64_t, kCount> draws_{};
    std::size_t ready_ = 0;
};

constinit thread_local BallCells ballCells;

}  // namespace

double randomBetween(double low, double high) {
    const double unit = static_cast<double>(seededGenerator().next() >> 11U) * 0x1p-53;
    const double value = low + (high - low) * unit;
    return value == high ? low : value;  // rounding may give the excluded upper bound
}

void seedRandom(std::uint64_t seed) {
    generator.restart(seed);
    ballCells.clear();
}

Vector3 Vector3::randomInsideUnitSphere() {
    return ballCells.take().middle();
}

}  // namespace raytracer
