#include <grader/tasks/support/Plots.h>

#include <grader/tasks/support/Draw.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ticker::tasks {
namespace {

constexpr std::size_t kMostPoints = 500;

/// Keeps every n-th point, so that all pixels and lights have their share.
void thin(std::vector<PlotPoint>& points) {
    const std::size_t step = (points.size() + kMostPoints - 1) / kMostPoints;
    if (step < 2) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); i += step)
        points[kept++] = points[i];
    points.resize(kept);
}

/// Half of a pixel of the handout's picture, at a distance of 1.
double halfPixel() {
    return std::tan(std::numbers::pi / 8.0) / raytracer::RenderSettings{}.width;
}

}  // namespace

ScatterPlot plotLens(const LensLog& log) {
    ScatterPlot plot;
    plot.title = "Where the rays start on the lens";
    plot.unit = "world units";
    plot.expectedShape = ScatterPlot::Shape::square;
    plot.expectedHalfWidth = log.asked->settings.dofAmount;
    plot.otherHalfWidth = 0.5 * plot.expectedHalfWidth;
    for (const LensPixel& pixel : log.pixels)
        for (const LensRay& ray : pixel.rays)
            plot.points.push_back({ray.origin.x, ray.origin.y});
    thin(plot.points);
    return plot;
}

ScatterPlot plotFocus(const LensLog& log) {
    ScatterPlot plot;
    plot.title = "Where the rays of a pixel cross the focal plane, as seen from its focal point";
    plot.unit = "world units";
    plot.expectedShape = ScatterPlot::Shape::disc;
    plot.expectedHalfWidth = halfPixel() * log.asked->settings.dofFocalPlane;
    for (const LensPixel& pixel : log.pixels) {
        const Vector3 focal = focalPointOf(pixel, log.asked->settings);
        for (const LensRay& ray : pixel.rays) {
            if (std::abs(ray.direction.z) < 1e-6) continue;
            const double distance = (focal.z - ray.origin.z) / ray.direction.z;
            const Vector3 beside = ray.origin + ray.direction * distance - focal;
            plot.points.push_back({beside.x, beside.y});
        }
    }
    thin(plot.points);
    return plot;
}

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
    return plots;
}

}  // namespace ticker::tasks
