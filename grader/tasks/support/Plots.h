#ifndef TICKER_TASKS_SUPPORT_PLOTS_H
#define TICKER_TASKS_SUPPORT_PLOTS_H

#include <grader/result/Finding.h>

#include <vector>

namespace ticker::tasks {

// Plots of the observed rays.

/// Reduces more than 500 points to every n-th, so that all pixels and lights are represented.
void thin(std::vector<PlotPoint>& points);

/// The plots that have points and that no finding shows already. At most one plot keeps its
/// drawing.
[[nodiscard]] std::vector<ScatterPlot> unshown(std::vector<ScatterPlot> plots,
                                               const std::vector<Finding>& findings);

}  // namespace ticker::tasks

#endif
