#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>
#include <grader/report/PageParts.h>
#include <grader/report/ReportWords.h>
#include <grader/result/RayDrawingJson.h>

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

/// The page's script makes a drawing of it; without scripts its words remain.
std::string rayFigure(const RayDrawing& drawing) {
    std::string words;
    for (const std::string& line : drawing.words)
        words += escapeHtml(line) + " ";
    return fmt::format(
        "<figure class=\"ray-figure\"><script type=\"application/json\">{}</script>"
        "<figcaption><strong>{}.</strong><noscript> {}</noscript></figcaption></figure>",
        rayDrawingJson(drawing), escapeHtml(drawing.about), words);
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
    for (const ScatterPlot& plot : plots) {
        // In a student's view a plot has no points, only the drawing of its rays.
        if (!plot.points.empty()) html += plotFigure(plot);
        if (plot.drawing) html += rayFigure(*plot.drawing);
    }
    for (const Raster& raster : rasters)
        html += rasterFigure(raster, album);
    return html;
}

}  // namespace ticker::report
