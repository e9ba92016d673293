#ifndef TICKER_TASKS_SHADOWS_ANSWERS_AIMDENSITY_H
#define TICKER_TASKS_SHADOWS_ANSWERS_AIMDENSITY_H

#include <grader/tasks/shadows/answers/AimFeet.h>
#include <grader/tasks/shadows/answers/ShadowAims.h>

#include <vector>

namespace ticker::tasks {

/// Whether the density of the lines lies between those of the accepted shapes: from each direction
/// and overall it is nowhere denser in the middle than the densest of them, nor denser at the rim
/// than the densest there, and some line comes as near to the rim as in every accepted shape. The
/// probability of a false "no" is below 1e-6.
/// @param verdict  Its `widest` and `distinct` are used.
[[nodiscard]] bool liesBetween(const Views& seen, const std::vector<Vector3>& directions,
                               const AimVerdict& verdict);

}  // namespace ticker::tasks

#endif
