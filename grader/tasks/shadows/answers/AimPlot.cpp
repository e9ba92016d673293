#include <grader/tasks/shadows/answers/AimPlot.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Plots.h>

#include <cstddef>

namespace ticker::tasks {

ScatterPlot plotAims(const std::vector<const ShadowLog*>& far) {
    ScatterPlot plot;
    plot.title = "Where the shadow rays pass the light's centre";
    plot.unit = "world units";
    plot.expectedShape = ScatterPlot::Shape::disc;
    if (far.empty()) return plot;
    plot.expectedHalfWidth = far.front()->settings().lightSize;
    for (const ShadowLog* log : far)
        for (const PointLog& point : log->points)
            for (std::size_t light = 0; light < point.lines.size(); ++light) {
                const Vector3 centre = log->scene().pointLights[light].position();
                const Perpendiculars sides =
                    perpendicularsOf((centre - point.point.position).normalised());
                for (const AimLine& line : point.lines[light])
                    plot.points.push_back(
                        {line.foot.dot(sides.first), line.foot.dot(sides.second)});
            }
    thin(plot.points);
    return plot;
}

}  // namespace ticker::tasks
