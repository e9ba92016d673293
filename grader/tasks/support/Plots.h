#ifndef TICKER_TASKS_DISTRIBUTED_PLOTS_H
#define TICKER_TASKS_DISTRIBUTED_PLOTS_H

#include <grader/tasks/lens/LensLog.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/result/Finding.h>

#include <vector>

namespace ticker::tasks {

// What was seen of the rays, for people. None holds more than some 500 points.

/// Where rays leave the lens, beside the two accepted squares.
[[nodiscard]] ScatterPlot plotLens(const LensLog& log);

/// Where the rays of each pixel cross the focal plane, seen from the pixel's focal point, beside
/// half a pixel of the handout's picture.
[[nodiscard]] ScatterPlot plotFocus(const LensLog& log);

/// Where shadow rays pass the light's centre, as seen from the shaded point, beside the light.
/// @param far  Logs of purpose farLight.
[[nodiscard]] ScatterPlot plotAims(const std::vector<const ShadowLog*>& far);

/// The plots that have points and that no finding shows already.
[[nodiscard]] std::vector<ScatterPlot> unshown(std::vector<ScatterPlot> plots,
                                               const std::vector<Finding>& findings);

}  // namespace ticker::tasks

#endif
