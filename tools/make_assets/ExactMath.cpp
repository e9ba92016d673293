#include "ExactMath.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assets {

double sineOfTurns(double turns) {
    double reduced = turns - std::floor(turns + 0.5);  // -0.5 to 0.5
    if (reduced > 0.25) reduced = 0.5 - reduced;
    if (reduced < -0.25) reduced = -0.5 - reduced;
    const double x = reduced * (2.0 * std::numbers::pi);
    const double square = x * x;
    // Taylor series, evaluated from the innermost term; at a quarter turn the first omitted term is
    // 6e-12.
    constexpr int kHighestPower = 15;
    double sum = 1.0;
    for (int power = kHighestPower; power > 1; power -= 2)
        sum = 1.0 - sum * square / (power * (power - 1));
    return x * sum;
}

double cosineOfTurns(double turns) {
    return sineOfTurns(turns + 0.25);
}

double smoothStep(double low, double high, double value) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

std::uint64_t mixed(std::uint64_t key) {
    std::uint64_t z = key + 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

double uniform(std::uint64_t key) {
    return static_cast<double>(mixed(key) >> 11U) * 0x1p-53;
}

}  // namespace assets
