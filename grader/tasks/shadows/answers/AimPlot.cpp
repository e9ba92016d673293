#include <grader/tasks/shadows/answers/AimPlot.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Plots.h>
#include <grader/tasks/support/SceneDrawing.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace ticker::tasks {
namespace {

/// How evenly a point's rays arrive and are blocked: 0 to a half.
double balanceOf(const PointLog& point) {
    std::size_t blocked = 0;
    for (const std::vector<AimLine>& lines : point.lines)
        blocked += static_cast<std::size_t>(std::ranges::count_if(lines, isBlocked));
    const double share = static_cast<double>(blocked) /
                         static_cast<double>(std::max<std::size_t>(1, point.lineCount()));
    return std::min(share, 1.0 - share);
}

RayDrawing::Ray drawLine(const ShadowLog& log, const AimLine& line, std::size_t light) {
    const double reach =
        (log.scene().pointLights[light].position() - line.origin).dot(line.direction);
    const bool blocked = isBlocked(line);
    const Vector3 end = blocked ? endInScene(log.scene(), line.origin, line.direction, reach)
                                : line.origin + line.direction * std::max(0.1, reach);
    return {blocked ? RayDrawing::Kind::blocked : RayDrawing::Kind::arrives, drawn(line.origin),
            drawn(end),
            fmt::format("shadow ray to light {}: {}; passes {:.3g} from the light's centre",
                        light + 1, blocked ? "is blocked" : "arrives", line.miss),
            static_cast<int>(light)};
}

/// The shadow rays of one point, at the edge of a shadow if there is such a point.
std::optional<RayDrawing> drawPoint(const std::vector<const ShadowLog*>& near) {
    constexpr std::size_t kMostRays = 80;
    const ShadowLog* log = nullptr;
    const PointLog* telling = nullptr;
    for (const ShadowLog* each : near)
        for (const PointLog& point : each->points)
            if (point.lineCount() > 0 &&
                (telling == nullptr || balanceOf(point) > balanceOf(*telling))) {
                log = each;
                telling = &point;
            }
    if (telling == nullptr) return std::nullopt;
    RayDrawing drawing = drawScene(log->scene(), log->settings().lightSize);
    drawing.about = "The shadow rays of one point, as this code casts them";
    drawing.words = {fmt::format("{} shadow rays of one point.", telling->lineCount()),
                     "Expected: they aim at points all over the light's ball."};
    for (std::size_t light = 0; light < telling->lines.size(); ++light)
        for (const AimLine& line : telling->lines[light])
            if (!line.isAdded && drawing.rays.size() < kMostRays)
                drawing.rays.push_back(drawLine(*log, line, light));
    return drawing;
}

}  // namespace

ScatterPlot plotAims(const std::vector<const ShadowLog*>& far,
                     const std::vector<const ShadowLog*>& near) {
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
    plot.drawing = drawPoint(near);
    return plot;
}

}  // namespace ticker::tasks
