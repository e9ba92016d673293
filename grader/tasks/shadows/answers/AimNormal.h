#ifndef TICKER_TASKS_SHADOWS_ANSWERS_AIMNORMAL_H
#define TICKER_TASKS_SHADOWS_ANSWERS_AIMNORMAL_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <vector>

namespace ticker::tasks {

/// How far the aims lie towards the side to which the surface's normal points, in radii of the
/// light: 3/8 for the half of an evenly filled ball; 0 if they do not lie as the normal does.
/// @param far  Logs of purpose farLight.
[[nodiscard]] double leanToNormal(const std::vector<const ShadowLog*>& far);

}  // namespace ticker::tasks

#endif
