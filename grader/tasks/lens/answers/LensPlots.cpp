#include <grader/tasks/lens/answers/LensPlots.h>
#include <grader/tasks/support/Plots.h>
#include <grader/tasks/support/SceneDrawing.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace ticker::tasks {
namespace {

/// The pixel with the most rays; null if no ray was seen.
const LensPixel* tellingPixel(const LensLog& log) {
    const auto most = std::ranges::max_element(
        log.pixels, {}, [](const LensPixel& pixel) { return pixel.rays.size(); });
    return most == log.pixels.end() || most->rays.empty() ? nullptr : &*most;
}

/// The rays of one pixel, with its pinhole ray up to the focal point; empty if no ray was seen.
std::optional<RayDrawing> drawPixel(const LensLog& log) {
    constexpr std::size_t kMostRays = 60;
    const LensPixel* pixel = tellingPixel(log);
    if (pixel == nullptr) return std::nullopt;
    const raytracer::RenderSettings& settings = log.asked->settings;
    const Vector3 focal = focalPointOf(*pixel, settings);
    RayDrawing drawing = drawScene(log.asked->scene, settings.lightSize);
    drawing.about = "The rays of one pixel, as this code casts them";
    drawing.words = {fmt::format("{} camera rays of one pixel.", pixel->rays.size()),
                     "Expected: they start in the square, the lens, and all pass one point, the "
                     "pixel's focal point."};
    drawing.lensHalfWidth = settings.dofAmount;
    drawing.focalPlane = settings.dofFocalPlane;
    drawing.rays.push_back({RayDrawing::Kind::expected,
                            {},
                            drawn(focal),
                            "the pinhole's ray, up to the focal point",
                            -1});
    for (std::size_t i = 0; i < std::min(kMostRays, pixel->rays.size()); ++i) {
        const LensRay& ray = pixel->rays[i];
        const Vector3 end =
            endInScene(log.asked->scene, ray.origin, ray.direction, 1.5 * settings.dofFocalPlane);
        const double away = (focal - ray.origin).cross(ray.direction).magnitude();
        drawing.rays.push_back(
            {RayDrawing::Kind::camera, drawn(ray.origin), drawn(end),
             fmt::format("camera ray {} starts at ({:.3g}, {:.3g}, {:.3g}), passes {:.2g} from the "
                         "focal point",
                         i + 1, ray.origin.x, ray.origin.y, ray.origin.z, away < 1e-6 ? 0.0 : away),
             -1});
    }
    return drawing;
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
    plot.drawing = drawPixel(log);
    return plot;
}

ScatterPlot plotFocus(const LensLog& log) {
    ScatterPlot plot;
    plot.title = "Where the rays of a pixel cross the focal plane, as seen from its focal point";
    plot.unit = "world units";
    plot.expectedShape = ScatterPlot::Shape::disc;
    // Of the handout's picture.
    plot.expectedHalfWidth =
        halfPixel(raytracer::RenderSettings{}.width) * log.asked->settings.dofFocalPlane;
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
    plot.drawing = drawPixel(log);
    return plot;
}

}  // namespace ticker::tasks
