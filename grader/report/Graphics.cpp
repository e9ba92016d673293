#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ticker::report {
namespace {

constexpr double kReach = 100.0;          // from the centre to the edge, user units of the SVG
constexpr std::size_t kMostPoints = 600;  // more points make the page slow

/// Half the width of the plot, in the plot's units: the expected shape and all finite points fit.
double reachOf(const ScatterPlot& plot) {
    double reach = std::max(plot.expectedHalfWidth, 0.0);
    for (const PlotPoint& point : plot.points)
        if (std::isfinite(point.x) && std::isfinite(point.y))
            reach = std::max({reach, std::abs(point.x), std::abs(point.y)});
    return reach > 0.0 ? reach * 1.12 : 1.0;
}

/// The largest of 1, 2 and 5 times a power of ten that is at most `reach`.
double tickFor(double reach) {
    const double power = std::pow(10.0, std::floor(std::log10(reach)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= reach) return factor * power;
    return power;
}

/// A text description of the picture, for screen readers.
std::string description(const ScatterPlot& plot) {
    PlotPoint low{1e300, 1e300};
    PlotPoint high{-1e300, -1e300};
    for (const PlotPoint& point : plot.points) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    if (plot.points.empty()) return "No points.";
    return fmt::format(
        "{} points, across from {:.3g} to {:.3g}, upwards from {:.3g} to {:.3g} {}. Expected: {} "
        "around the middle, {:.3g} from there to its edge.",
        plot.points.size(), low.x, high.x, low.y, high.y, plot.unit,
        plot.expectedShape == ScatterPlot::Shape::disc ? "a disc" : "a square",
        plot.expectedHalfWidth);
}

/// A frame with a scale below and on the left, and a cross at the centre.
std::string axes(double scale, double reach) {
    const double tick = tickFor(reach);
    std::string svg = R"(<path class="axes" d="M-100-100H100V100H-100ZM-100 0H100M0-100V100)";
    std::string labels;
    for (const double value : {-tick, 0.0, tick}) {
        const double at = value * scale;
        svg += fmt::format("M{0:.1f} 100v4M-100 {0:.1f}h-4", at);
        labels += fmt::format(
            R"(<text x="{0:.1f}" y="114">{1:.3g}</text><text class="up" x="-106" y="{2:.1f}">{1:.3g}</text>)",
            at, value, 3.0 - at);
    }
    return svg + "\"/>" + labels;
}

std::string outline(ScatterPlot::Shape shape, double half, std::string_view kind) {
    if (shape == ScatterPlot::Shape::disc)
        return fmt::format(R"(<circle class="{}" r="{:.1f}"/>)", kind, half);
    return fmt::format(
        R"(<rect class="{0}" x="{1:.1f}" y="{1:.1f}" width="{2:.1f}" height="{2:.1f}"/>)", kind,
        -half, 2.0 * half);
}

/// All points as one path of round-capped strokes of zero length: a page with thousands of elements
/// is slow.
std::string dots(const ScatterPlot& plot, double scale) {
    std::string path;
    const std::size_t stride = plot.points.size() / (kMostPoints + 1) + 1;
    for (std::size_t i = 0; i < plot.points.size(); i += stride) {
        const PlotPoint& point = plot.points[i];
        if (std::isfinite(point.x) && std::isfinite(point.y))
            path += fmt::format("M{:.1f} {:.1f}h0", point.x * scale, -point.y * scale);
    }
    return fmt::format(R"(<path class="dots" d="{}"/>)", path);
}

}  // namespace

std::string base64(std::string_view bytes) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t triple = 0;
        for (std::size_t k = 0; k < 3; ++k)
            triple = (triple << 8U) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? kDigits[(triple >> (18U - 6U * k)) & 63U] : '=';
    }
    return text;
}

std::string pngAddress(std::string_view png) {
    return "data:image/png;base64," + base64(png);
}

std::string scatterSvg(const ScatterPlot& plot) {
    const double reach = reachOf(plot);
    const double scale = kReach / reach;
    std::string svg = fmt::format(
        R"(<svg class="plot" role="img" aria-label="{}. {}" viewBox="-142 -104 248 222">)",
        escapeHtml(plot.title), escapeHtml(description(plot)));
    svg += outline(plot.expectedShape, plot.expectedHalfWidth * scale, "expected");
    if (plot.otherHalfWidth > 0.0)
        svg += outline(plot.expectedShape, plot.otherHalfWidth * scale, "expected other");
    return svg + dots(plot, scale) + axes(scale, reach) + "</svg>";
}

}  // namespace ticker::report
