#ifndef TICKER_TASKS_BUMP_RAMPJUDGEMENT_H
#define TICKER_TASKS_BUMP_RAMPJUDGEMENT_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/questions/Ramps.h>

#include <optional>
#include <vector>

namespace ticker::tasks::bump {

/// What one set of ramps shows about a submission.
enum class RampKind {
    right,
    silent,  ///< no ramp tilts anything
    longitudeDependent,
    swapped,
    inverted,
    invertedU,
    invertedV,
    slopeUIgnored,           ///< a slope along u alone tilts nothing
    slopeVIgnored,           ///< a slope along v alone tilts nothing
    signLost,                ///< falling slopes tilt like rising ones
    strangeParametrisation,  ///< polar coordinates do not explain where texels lie
    patchy,                  ///< right, but many points are not tilted
    strangeDirection         ///< the tilts fit no known reading
};

struct RampJudgement {
    RampKind kind = RampKind::silent;
    RampShape shape;  ///< of the ramps
    RampStrength strength;
    std::optional<ParametrisationFit> fit;  ///< present if enough points show their place
    std::optional<Response> response;       ///< present if the fit is good
    bool transposed = false;                ///< columns follow the polar angle, rows the longitude
};

[[nodiscard]] RampJudgement judgeRamps(const RampShape& shape, const std::vector<RampTilts>& tilts);

}  // namespace ticker::tasks::bump

#endif
