#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>

#include <raytracer/io/ImageWriter.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ticker::report {
namespace {

constexpr double kPlotSide = 200.0;        // user units of the SVG
constexpr std::size_t kMostPoints = 2000;  // more only make the page heavy

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

/// Half the width of the plot, in the plot's own units: everything that matters fits in.
double reachOf(const ScatterPlot& plot) {
    double reach = plot.expectedHalfWidth;
    for (const PlotPoint& point : plot.points)
        if (std::isfinite(point.x) && std::isfinite(point.y))
            reach = std::max({reach, std::abs(point.x), std::abs(point.y)});
    return reach > 0.0 ? reach * 1.1 : 1.0;
}

std::array<std::uint8_t, 3> grey(float value) {
    const auto byte = static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F);
    return {byte, byte, byte};
}

/// Blue below 0, red above, paper white at 0.
std::array<std::uint8_t, 3> diverging(float value) {
    const float v = std::clamp(value, -1.0F, 1.0F);
    const float fade = 1.0F - std::abs(v);
    const auto mix = [&](float full) {
        return static_cast<std::uint8_t>(245.0F * fade + full * (1.0F - fade));
    };
    return v < 0.0F ? std::array{mix(33), mix(102), mix(172)}
                    : std::array{mix(178), mix(24), mix(43)};
}

}  // namespace

std::string pngAddress(std::string_view png) {
    return "data:image/png;base64," + base64(png);
}

std::string scatterSvg(const ScatterPlot& plot) {
    const double scale = kPlotSide / 2.0 / reachOf(plot);
    const double half = plot.expectedHalfWidth * scale;
    std::string svg =
        fmt::format(R"(<svg class="plot" role="img" aria-label="{}" viewBox="{} {} {} {}">)",
                    escapeHtml(plot.title), -kPlotSide / 2, -kPlotSide / 2, kPlotSide, kPlotSide);
    svg += R"(<path d="M-100 0H100M0-100V100" stroke="currentColor" stroke-opacity=".2"/>)";
    svg += R"svg(<g fill="var(--accent)" fill-opacity=".55">)svg";
    const std::size_t stride = plot.points.size() / kMostPoints + 1;
    for (std::size_t i = 0; i < plot.points.size(); i += stride) {
        const PlotPoint& point = plot.points[i];
        if (std::isfinite(point.x) && std::isfinite(point.y))
            svg += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="1.3"/>)", point.x * scale,
                               -point.y * scale);
    }
    svg += "</g>";
    const std::string style = R"svg(fill="none" stroke="var(--bad)" stroke-width="1.5")svg";
    if (plot.expectedShape == ScatterPlot::Shape::disc)
        svg += fmt::format(R"(<circle r="{:.1f}" {}/>)", half, style);
    else
        svg += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" {}/>)",
                           -half, -half, 2 * half, 2 * half, style);
    return svg + "</svg>";
}

std::string rasterPng(const Raster& raster) {
    raytracer::ByteImage image{raster.width, raster.height, {}};
    image.rgb.reserve(raster.values.size() * 3);
    for (const float value : raster.values)
        for (const std::uint8_t byte :
             raster.colours == Raster::Colours::grey ? grey(value) : diverging(value))
            image.rgb.push_back(byte);
    return raytracer::encodePng(image);
}

}  // namespace ticker::report
