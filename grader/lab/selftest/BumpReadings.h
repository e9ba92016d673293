#ifndef TICKER_SELFTEST_BUMPREADINGS_H
#define TICKER_SELFTEST_BUMPREADINGS_H

#include <grader/lab/selftest/BumpModel.h>

#include <vector>

namespace ticker::selftest {

/// The cross product of readings that must pass: u origin x sampling x edge rule x difference x
/// gain x strength x mirrored, each with its neighbours' choices of precision, axis, tangents and
/// heights.
[[nodiscard]] std::vector<Reading> acceptedReadings();

/// Readings that mistakes are crossed with.
[[nodiscard]] std::vector<Reading> readingsForMistakes();

/// Every mistake that the model knows.
[[nodiscard]] std::vector<Mistake> allMistakes();

/// False for what a displaced surface's normal has no place for: tangents, the sum, single
/// differences.
[[nodiscard]] bool canHaveMistake(const Reading& reading, Mistake mistake);

/// The reading, changed where a mistake would be none, or another one, in it.
[[nodiscard]] Reading fittingFor(Mistake mistake, Reading reading);

}  // namespace ticker::selftest

#endif
