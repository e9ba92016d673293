#ifndef TOOLS_MAKE_ASSETS_EXACTMATH_H
#define TOOLS_MAKE_ASSETS_EXACTMATH_H

#include <cstdint>

/// Mathematics whose results are bitwise equal on every machine: it uses only additions,
/// multiplications, divisions and square roots, which IEEE 754 rounds exactly, and none of the C
/// library's functions, which differ between versions.
namespace assets {

/// Sine of an angle in turns (1 is the full circle).
[[nodiscard]] double sineOfTurns(double turns);

/// Cosine of an angle in turns.
[[nodiscard]] double cosineOfTurns(double turns);

/// 3 t^2 - 2 t^3 between `low` and `high`; 0 below, 1 above.
[[nodiscard]] double smoothStep(double low, double high, double value);

/// A hash of the key, 64 bits (splitmix64).
[[nodiscard]] std::uint64_t mixed(std::uint64_t key);

/// A number in [0, 1) that depends on the key alone.
[[nodiscard]] double uniform(std::uint64_t key);

}  // namespace assets

#endif
