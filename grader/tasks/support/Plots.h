#ifndef TICKER_TASKS_SUPPORT_PLOTS_H
#define TICKER_TASKS_SUPPORT_PLOTS_H

#include <grader/result/Finding.h>

#include <vector>

namespace ticker::tasks {

// What was seen of the rays, for people.

/// Keeps every n-th of more than 500 points, so that all pixels and lights have their share.
void thin(std::vector<PlotPoint>& points);

/// The plots that have points and that no finding shows already.
[[nodiscard]] std::vector<ScatterPlot> unshown(std::vector<ScatterPlot> plots,
                                               const std::vector<Finding>& findings);

}  // namespace ticker::tasks

#endif
