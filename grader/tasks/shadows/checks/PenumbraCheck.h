#ifndef TICKER_TASKS_DISTRIBUTED_PENUMBRACHECK_H
#define TICKER_TASKS_DISTRIBUTED_PENUMBRACHECK_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/questions/PenumbraQuestion.h>

#include <optional>

namespace ticker::tasks {

struct PenumbraVerdict {
    std::optional<Finding> finding;
    /// Of the accepted reading that fits best: the largest deviation of a mean, in units of what
    /// Bernstein's inequality allows.
    double timesTheBound = 0.0;
    /// Every call gives the same value, so that there are no means to judge: a person should read
    /// the code.
    bool ambiguous = false;
};

/// Judges the values alone: whether they are fractions of as many rays as were asked for, whether
/// their means are those of some accepted reading, and whether light comes from where the light's
/// outermost part is, and from nowhere beyond. Bernstein's inequality bounds the difference of
/// means, so that a correct submission whose calls are independent is reported with a chance below
/// 1e-9.
[[nodiscard]] PenumbraVerdict checkPenumbra(const PenumbraQuestion& asked,
                                            const probe::IlluminateAnswer& answer);

}  // namespace ticker::tasks

#endif
