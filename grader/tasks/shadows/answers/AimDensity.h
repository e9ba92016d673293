#ifndef TICKER_TASKS_DISTRIBUTED_AIMDENSITY_H
#define TICKER_TASKS_DISTRIBUTED_AIMDENSITY_H

#include <grader/tasks/shadows/answers/AimFeet.h>
#include <grader/tasks/shadows/answers/ShadowAims.h>

#include <vector>

namespace ticker::tasks {

/// Whether the distances of the lines from the light's centre lie between those of the accepted
/// shapes: seen from each direction and all together, nowhere denser in the middle than the densest
/// nor denser at the rim than the densest there, and with a line as near to the rim as every
/// accepted shape has one. A density that does lie between is refused with a chance below 1e-6.
/// @param verdict  Its `widest` and `distinct` count.
[[nodiscard]] bool liesBetween(const Views& seen, const std::vector<Vector3>& directions,
                               const AimVerdict& verdict);

}  // namespace ticker::tasks

#endif
