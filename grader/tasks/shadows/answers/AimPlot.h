#ifndef TICKER_TASKS_SHADOWS_AIMPLOT_H
#define TICKER_TASKS_SHADOWS_AIMPLOT_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <vector>

namespace ticker::tasks {

/// Where shadow rays pass the light's centre, seen from the shaded point, with the light's outline.
/// @param far   Logs of purpose farLight.
/// @param near  Logs with points of which a part of the light is hidden: one of them is drawn.
[[nodiscard]] ScatterPlot plotAims(const std::vector<const ShadowLog*>& far,
                                   const std::vector<const ShadowLog*>& near);

}  // namespace ticker::tasks

#endif
