#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>
#include <grader/report/PageParts.h>
#include <grader/report/Words.h>

#include <fmt/core.h>

namespace ticker::report {
namespace {

/// A picture of a result, by its file; empty where the result has no such file.
struct Found {
    std::string source;   ///< for the attribute src
    std::string caption;  ///< for the attribute alt, escaped
};

Found find(const SubmissionResult& result, const std::string& file, const std::string& otherwise) {
    if (file.rfind("images/", 0) != 0) return {};  // nowhere else, and no other host
    for (const ResultPicture& picture : result.pictures)
        if (picture.file == file && !picture.png.empty())
            return {pngAddress(picture.png), escapeHtml(picture.caption)};
    // A result that was read back does not hold its pictures; they lie beside the page.
    return {address(file), escapeHtml(otherwise)};
}

std::string framed(const Found& picture, std::string_view kind, std::string_view caption) {
    return fmt::format(
        "<figure class=\"{}\"><div class=\"frame\"><img src=\"{}\" alt=\"{}\"></div>"
        "<figcaption>{}</figcaption></figure>",
        kind, picture.source, picture.caption, caption);
}

std::string scores(const RenderScore& render) {
    return fmt::format(
        "<dl class=\"scores\"><div><dt>FLIP</dt><dd>{:.3f} <small>0: looks equal</small></dd></div>"
        "<div><dt>SSIM</dt><dd>{:.3f} <small>1: equal</small></dd></div>"
        "<div><dt>GMSD</dt><dd>{:.3f} <small>0: equal edges</small></dd></div>"
        "<div><dt>RMSE</dt><dd>{:.2f} <small>of 255</small></dd></div></dl>",
        render.flip, render.ssim, render.gmsd, render.rmse);
}

constexpr std::string_view kControls =
    "<div class=\"controls screen-only\">"
    "<button type=\"button\" data-act=\"over\" aria-pressed=\"false\" aria-keyshortcuts=\"o\">"
    "One over the other <kbd>O</kbd></button>"
    "<button type=\"button\" data-act=\"blink\" aria-pressed=\"false\" aria-keyshortcuts=\"b\">"
    "Blink <kbd>B</kbd></button>"
    "<label class=\"wipe\">Expected <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
    "aria-label=\"How much of the submitted picture lies over the expected one\"> Submitted"
    "</label>"
    "<span class=\"zoom\"><button type=\"button\" data-act=\"out\" aria-label=\"Zoom out\" "
    "aria-keyshortcuts=\"-\">&minus;</button><output aria-live=\"polite\">1&times;</output>"
    "<button type=\"button\" data-act=\"in\" aria-label=\"Zoom in\" aria-keyshortcuts=\"+\">+"
    "</button></span><span class=\"showing\" role=\"status\"></span></div>";

std::string comparison(const SubmissionResult& result, const RenderScore& render) {
    const Found expected =
        find(result, render.reference, render.scene + " as the model answer renders it");
    const Found submitted =
        find(result, render.image, render.scene + " as this submission renders it");
    if (submitted.source.empty()) return "";
    const bool pair = !expected.source.empty();
    std::string html = fmt::format(
        "<section class=\"{}\"><h3>{} <span class=\"soft\">{} &times; {}</span></h3>{}"
        "<div class=\"pair\" tabindex=\"{}\" role=\"group\" aria-label=\"{}: expected and "
        "submitted picture\">",
        pair ? "compare" : "alone", escapeHtml(render.scene), render.width, render.height,
        pair ? scores(render) : "", pair ? 0 : -1, escapeHtml(render.scene));
    if (pair) html += framed(expected, "expected", "Expected: the model answer");
    html += framed(submitted, "submitted", "From this submission&#39;s code") + "</div>";
    if (pair) html += kControls;
    const Found map = find(result, render.errorMap, render.scene + ", FLIP error map");
    if (!map.source.empty())
        html += "<details><summary>Where they look different</summary>" +
                framed(map, "map", "FLIP error: black is equal, bright is different") +
                "</details>";
    return html + "</section>";
}

std::string screenshot(const SubmissionResult& result) {
    for (const ResultPicture& picture : result.pictures)
        if (picture.file == kScreenshotFile && !picture.png.empty())
            return "<section class=\"alone\"><h3>screenshot.png as handed in</h3>" +
                   framed({pngAddress(picture.png), escapeHtml(picture.caption)}, "screenshot",
                          escapeHtml(picture.caption)) +
                   "</section>";
    return "";
}

}  // namespace

std::string picturesSection(const SubmissionResult& result) {
    std::string html;
    for (const RenderScore& render : result.renders)
        html += comparison(result, render);
    html += screenshot(result);
    if (html.empty()) return "";
    return "<section id=\"pictures\"><h2>Pictures</h2><p class=\"soft\">They explain; they do not "
           "decide. <span class=\"screen-only\">Keys: <kbd>B</kbd> blinks between expected and "
           "submitted, <kbd>O</kbd> lays one over the other, <kbd>+</kbd> <kbd>&minus;</kbd> zoom "
           "both, the pointer or the arrow keys move them.</span></p>" +
           html + "</section>";
}

}  // namespace ticker::report
