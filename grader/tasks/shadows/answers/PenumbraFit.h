#ifndef TICKER_TASKS_DISTRIBUTED_PENUMBRAFIT_H
#define TICKER_TASKS_DISTRIBUTED_PENUMBRAFIT_H

#include <grader/tasks/shadows/answers/PenumbraShares.h>

#include <vector>

namespace ticker::tasks {

/// How well the means at the edge of a shadow fit what is accepted.
struct PenumbraFit {
    double excess = 1e9;             ///< of the best reading, as `worstExcess` has it
    std::vector<double> openInBall;  ///< share of aims in sight at each place, for a filled ball
};

/// Tries every accepted shape of the light, densities between two of them, and every reading of
/// Phong.
/// @param sizeIsInDoubt  By what the rim says: then shapes whose means are those of a ball of
///                       another size are left out.
[[nodiscard]] PenumbraFit fitAcceptedShapes(const probe::IlluminateQuestion& asked,
                                            const Surfaces& surfaces,
                                            const std::vector<PenumbraSamples>& seen,
                                            bool sizeIsInDoubt);

}  // namespace ticker::tasks

#endif
