#ifndef TICKER_TASKS_DISTRIBUTED_BOUNDS_H
#define TICKER_TASKS_DISTRIBUTED_BOUNDS_H

#include <cstddef>
#include <functional>
#include <vector>

namespace ticker::tasks {

/// The chance that one statistical statement about a correct submission is wrong. A decision makes
/// fewer than 100 of them: together they fail a correct submission with a chance below 1e-9.
inline constexpr double kStatementRisk = 1e-11;

/// Largest distance between the distribution function of `count` independent samples and the true
/// one, exceeded with a chance of at most `risk` (Dvoretzky-Kiefer-Wolfowitz with Massart's
/// constant; holds for every count). Stratified and low-discrepancy samples lie closer.
[[nodiscard]] double dkwBound(std::size_t count, double risk = kStatementRisk);

/// The smallest share p such that `count` independent trials of chance p all fail with a chance of
/// at most `risk`: (1 - p)^count = risk.
[[nodiscard]] double missedShare(std::size_t count, double risk = kStatementRisk);

/// Bound on the chance that `hits` of `count` independent trials of chance `p` lie as far off as
/// they do (Chernoff 1952: exp(-count KL(hits/count || p))); 1 where they do not.
[[nodiscard]] double chernoffTail(std::size_t hits, std::size_t count, double p);

/// Largest distance between the distribution function of the samples and a given one.
/// @param samples  Sorted here.
[[nodiscard]] double largestGap(std::vector<double> samples,
                                const std::function<double(double)>& distribution);

/// The same, between two sets of samples, both sorted, the left one divided by `size`.
[[nodiscard]] double largestGap(const std::vector<double>& left, const std::vector<double>& right,
                                double size = 1.0);

}  // namespace ticker::tasks

#endif
