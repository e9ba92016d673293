#include <grader/tasks/lens/LensPlots.h>
#include <grader/tasks/support/Plots.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

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

}  // namespace ticker::tasks
