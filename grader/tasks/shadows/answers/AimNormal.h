#ifndef TICKER_TASKS_SHADOWS_ANSWERS_AIMNORMAL_H
#define TICKER_TASKS_SHADOWS_ANSWERS_AIMNORMAL_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <vector>

namespace ticker::tasks {

/// How far the aims lean towards the side that the surface's normal points to, in radii of the
/// light: 3/8 for half of an evenly filled ball. 0 if their offset does not follow the normal.
/// @param far  Logs of purpose farLight.
[[nodiscard]] double leanToNormal(const std::vector<const ShadowLog*>& far);

}  // namespace ticker::tasks

#endif
