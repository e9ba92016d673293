#ifndef TICKER_TASKS_SHADOWS_ANSWERS_AIMVIEWER_H
#define TICKER_TASKS_SHADOWS_ANSWERS_AIMVIEWER_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <vector>

namespace ticker::tasks {

/// How much less (below 0) or more the feet of far lights spread towards the viewer than across,
/// in standard deviations; 0 where all viewers stand in one direction from the light's axis.
[[nodiscard]] double spreadTowardsViewer(const std::vector<const ShadowLog*>& far,
                                         const std::vector<Vector3>& directions);

/// Whether the shape in which the lines of far lights lie turns with the viewer, as a disc does
/// that faces O. The probability for a right submission is below 1e-9.
[[nodiscard]] bool turnsWithViewer(const std::vector<const ShadowLog*>& far,
                                   const std::vector<Vector3>& directions);

}  // namespace ticker::tasks

#endif
