#ifndef TICKER_TASKS_SUPPORT_BOUNDS_H
#define TICKER_TASKS_SUPPORT_BOUNDS_H

#include <cstddef>
#include <functional>
#include <vector>

namespace ticker::tasks {

/// Risk that one statistical statement about a correct submission is wrong. A decision makes fewer
/// than 100 of them, so that a correct submission fails with a chance below 1e-9.
inline constexpr double kStatementRisk = 1e-11;

/// Confidence bound on the largest distance between the distribution function of `count`
/// independent samples and the true one, exceeded with a chance of at most `risk`
/// (Dvoretzky-Kiefer-Wolfowitz with Massart's constant; holds for every count). Stratified and
/// low-discrepancy samples lie closer.
[[nodiscard]] double dkwBound(std::size_t count, double risk = kStatementRisk);

/// The probability p at which `count` independent trials all fail with a chance of `risk`: (1 -
/// p)^count = risk.
[[nodiscard]] double missedShare(std::size_t count, double risk = kStatementRisk);

/// Bound on the chance that `count` independent trials of probability `p` deviate from `p` at least
/// as far as `hits` does, to the same side (Chernoff 1952: exp(-count KL(hits/count || p))). It is
/// small for deviations to either side: a caller that tests one side compares hits/count with `p`.
[[nodiscard]] double chernoffTail(std::size_t hits, std::size_t count, double p);

/// Largest distance between the distribution function of the samples and a given one.
/// @param samples  Need not be sorted.
[[nodiscard]] double largestGap(std::vector<double> samples,
                                const std::function<double(double)>& distribution);

/// Largest distance between the empirical distribution functions of two sorted sets of samples (the
/// two-sample Kolmogorov-Smirnov statistic).
/// @param size  The values of `left` are divided by it first.
[[nodiscard]] double largestGap(const std::vector<double>& left, const std::vector<double>& right,
                                double size = 1.0);

}  // namespace ticker::tasks

#endif
