#ifndef TOOLS_MAKE_ASSETS_EXACTMATH_H
#define TOOLS_MAKE_ASSETS_EXACTMATH_H

#include <cstdint>

/// Mathematics whose results are the same bits on every machine: additions, multiplications,
/// divisions and square roots, which IEEE 754 rounds exactly, and none of the C library's
/// functions, which differ from one version to the next.
namespace assets {

/// Sine of an angle in turns (1 is the full circle).
[[nodiscard]] double sineOfTurns(double turns);

/// Cosine of an angle in turns.
[[nodiscard]] double cosineOfTurns(double turns);

/// 3 t^2 - 2 t^3 between `low` and `high`; 0 below, 1 above.
[[nodiscard]] double smoothStep(double low, double high, double value);

/// A well mixed 64-bit number for each key (splitmix64).
[[nodiscard]] std::uint64_t mixed(std::uint64_t key);

/// In [0, 1), from a key.
[[nodiscard]] double uniform(std::uint64_t key);

}  // namespace assets

#endif
