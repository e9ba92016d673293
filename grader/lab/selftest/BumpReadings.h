#ifndef TICKER_SELFTEST_BUMPREADINGS_H
#define TICKER_SELFTEST_BUMPREADINGS_H

#include <grader/lab/selftest/BumpModel.h>

#include <cstdint>
#include <vector>

namespace ticker::selftest {

/// The cross product of accepted readings: gain x sampling x difference x mirrored, twice.
/// Everything else (origin of u, edge rule, strength, precision, axis, tangents, heights) is drawn
/// for each.
[[nodiscard]] std::vector<Reading> acceptedReadings(std::uint64_t seed);

/// The readings that are combined with mistakes.
[[nodiscard]] std::vector<Reading> readingsForMistakes();

/// All mistakes of the model.
[[nodiscard]] std::vector<Mistake> allMistakes();

/// False for mistakes that cannot occur in a displaced surface's normal: in tangents, in the sum,
/// in single differences.
[[nodiscard]] bool canHaveMistake(const Reading& reading, Mistake mistake);

/// The reading, changed if the mistake would have no effect, or another effect, in it.
[[nodiscard]] Reading fittingFor(Mistake mistake, Reading reading);

}  // namespace ticker::selftest

#endif
