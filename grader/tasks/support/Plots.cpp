#include <grader/tasks/support/Plots.h>

#include <algorithm>
#include <cstddef>

namespace ticker::tasks {

void thin(std::vector<PlotPoint>& points) {
    constexpr std::size_t kMostPoints = 500;
    const std::size_t step = (points.size() + kMostPoints - 1) / kMostPoints;
    if (step < 2) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); i += step)
        points[kept++] = points[i];
    points.resize(kept);
}

std::vector<ScatterPlot> unshown(std::vector<ScatterPlot> plots,
                                 const std::vector<Finding>& findings) {
    std::erase_if(plots, [&](const ScatterPlot& plot) {
        return plot.points.empty() ||
               std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
                   return std::any_of(
                       finding.plots.begin(), finding.plots.end(),
                       [&](const ScatterPlot& shown) { return shown.title == plot.title; });
               });
    });
    bool isDrawn = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return std::any_of(finding.plots.begin(), finding.plots.end(),
                           [](const ScatterPlot& shown) { return shown.drawing.has_value(); });
    });
    for (ScatterPlot& plot : plots) {
        if (isDrawn) plot.drawing.reset();
        isDrawn = isDrawn || plot.drawing;
    }
    return plots;
}

}  // namespace ticker::tasks
