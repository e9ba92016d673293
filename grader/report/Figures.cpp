#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>
#include <grader/report/PageParts.h>
#include <grader/report/Words.h>

#include <fmt/core.h>

namespace ticker::report {
namespace {

std::string expectation(const ScatterPlot& plot) {
    const bool disc = plot.expectedShape == ScatterPlot::Shape::disc;
    std::string text = fmt::format("{} of {} {:.3g}", disc ? "a disc" : "a square",
                                   disc ? "radius" : "half-width", plot.expectedHalfWidth);
    if (plot.otherHalfWidth > 0.0) text += fmt::format(" or {:.3g}", plot.otherHalfWidth);
    return text + " " + plot.unit;
}

std::string plotFigure(const ScatterPlot& plot) {
    return fmt::format(
        "<figure>{}<figcaption><strong>{}.</strong> {} points; <span class=\"outline\">outlined"
        "</span>: what was expected, {}.</figcaption></figure>",
        scatterSvg(plot), escapeHtml(plot.title), plot.points.size(),
        escapeHtml(expectation(plot)));
}

std::string rasterFigure(const Raster& raster, const Album& album) {
    const std::string source = album.addressOf(raster.image);
    if (source.empty()) return "";
    return fmt::format(R"(<figure><img src="{}" alt="{}"><figcaption>{}</figcaption></figure>)",
                       source, escapeHtml(raster.title), escapeHtml(sentence(raster.title)));
}

}  // namespace

std::string figures(const std::vector<ScatterPlot>& plots, const std::vector<Raster>& rasters,
                    const Album& album) {
    std::string html;
    for (const ScatterPlot& plot : plots)
        html += plotFigure(plot);
    for (const Raster& raster : rasters)
        html += rasterFigure(raster, album);
    return html;
}

}  // namespace ticker::report
