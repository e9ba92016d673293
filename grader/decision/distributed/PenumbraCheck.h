#ifndef TICKER_DECISION_DISTRIBUTED_PENUMBRACHECK_H
#define TICKER_DECISION_DISTRIBUTED_PENUMBRACHECK_H

#include <grader/probe/Question.h>
#include <grader/result/Finding.h>

#include <cstdint>
#include <optional>

namespace ticker::decision {

/// A question for code whose shadow rays cannot be seen: points at the edge of a shadow, each asked
/// hundreds of times, without a log.
[[nodiscard]] probe::IlluminateQuestion drawPenumbraQuestion(std::uint64_t seed);

struct PenumbraVerdict {
    std::optional<Finding> finding;
    /// The values fit, but only for points on the light's surface or crowded at its centre, which
    /// look like those of a ball of another size: a person should read the code.
    bool ambiguous = false;
};

/// Judges the values alone: whether they are fractions of as many rays as were asked for, and
/// whether their means are those of some accepted reading. Bernstein's inequality bounds the
/// difference, so that a correct submission whose calls are independent is reported with a chance
/// below 1e-9.
[[nodiscard]] PenumbraVerdict checkPenumbra(const probe::IlluminateQuestion& asked,
                                            const probe::IlluminateAnswer& answer);

}  // namespace ticker::decision

#endif
