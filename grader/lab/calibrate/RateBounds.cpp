#include <grader/lab/calibrate/RateBounds.h>

#include <cmath>

namespace ticker::calibrate {
namespace {

// Binomial probability of at most `hits` successes.
double chanceOfAtMost(std::size_t hits, std::size_t count, double p) {
    const auto n = static_cast<double>(count);
    double log = n * std::log1p(-p);
    double chance = std::exp(log);
    for (std::size_t k = 1; k <= hits; ++k) {
        const auto at = static_cast<double>(k);
        log += std::log((n - at + 1.0) / at * p / (1.0 - p));
        chance += std::exp(log);
    }
    return chance;
}

}  // namespace

double upperBound(std::size_t hits, std::size_t count) {
    if (hits >= count) return 1.0;
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double p = 0.5 * (low + high);
        (chanceOfAtMost(hits, count, p) > 0.05 ? low : high) = p;
    }
    return high;
}

}  // namespace ticker::calibrate
