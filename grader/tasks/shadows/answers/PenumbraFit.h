#ifndef TICKER_TASKS_SHADOWS_ANSWERS_PENUMBRAFIT_H
#define TICKER_TASKS_SHADOWS_ANSWERS_PENUMBRAFIT_H

#include <grader/tasks/shadows/answers/PenumbraShares.h>

#include <vector>

namespace ticker::tasks {

/// How well the means in the penumbra fit the accepted readings.
struct PenumbraFit {
    double excess = 1e9;             ///< worstExcess of the best reading
    std::vector<double> openInBall;  ///< share of visible aims at each place, for a filled ball
};

/// Tries every accepted shape of the light, densities between two of them, and every Phong reading.
/// @param sizeIsInDoubt  True if the light from the rim suggests a wrong size. Shapes whose means
///                       equal those of a ball of another size are then left out.
[[nodiscard]] PenumbraFit fitAcceptedShapes(const probe::IlluminateQuestion& asked,
                                            const Surfaces& surfaces,
                                            const std::vector<PenumbraSamples>& seen,
                                            bool sizeIsInDoubt);

}  // namespace ticker::tasks

#endif
