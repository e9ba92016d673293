#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRACHECK_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRACHECK_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>

#include <optional>

namespace ticker::tasks {

struct PenumbraVerdict {
    /// Fails, or warns of an accepted reading whose pictures differ from the handout's.
    std::optional<Finding> finding;
    /// Largest deviation of a mean under the best accepted reading, in units of Bernstein's bound.
    double timesTheBound = 0.0;
    /// Every call returns the same value, so that there are no means to judge: needs review.
    bool ambiguous = false;
};

/// Judges values without rays. Values must be fractions of as many rays as were asked for. Their
/// means must be those of an accepted reading. Light must come from the light's outermost part, but
/// not from beyond it. Bernstein's inequality bounds the differences of means: a correct submission
/// whose calls are independent fails with a chance below 1e-9.
/// @param expectations  Of the question that was answered.
[[nodiscard]] PenumbraVerdict checkPenumbra(PenumbraExpectations& expectations,
                                            const probe::IlluminateAnswer& answer);

}  // namespace ticker::tasks

#endif
