#ifndef TICKER_TASKS_SHADOWS_AIMPLOT_H
#define TICKER_TASKS_SHADOWS_AIMPLOT_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <vector>

namespace ticker::tasks {

/// Where shadow rays pass the light's centre, seen from the shaded point, with the light's outline.
/// @param far  Logs of purpose farLight.
[[nodiscard]] ScatterPlot plotAims(const std::vector<const ShadowLog*>& far);

}  // namespace ticker::tasks

#endif
