#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/ReportWords.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

namespace ticker::report {
namespace {

/// One picture of a comparison.
struct Shown {
    std::string source;   ///< for the attribute src
    std::string kind;     ///< its class: expected, submitted, flip, z
    std::string alt;      ///< plain text
    std::string caption;  ///< HTML
};

std::string scale(std::string_view kind, std::string_view low, std::string_view high) {
    return fmt::format(
        "<span class=\"scale\" aria-hidden=\"true\">{}<span class=\"ramp {}\"></span>{}</span>",
        low, kind, high);
}

std::string figure(const Shown& shown) {
    const bool upper = shown.kind == "submitted";
    return fmt::format(
        "<figure class=\"{}\"><div class=\"box\"><div class=\"frame\">"
        "<img src=\"{}\" alt=\"{}\" "
        "draggable=\"false\"></div>{}</div><figcaption>{}</figcaption></figure>",
        shown.kind, shown.source, escapeHtml(shown.alt),
        upper ? "<div class=\"divider screen-only\"></div>" : "", shown.caption);
}

std::string score(std::string_view name, double value, int digits, std::string_view meaning) {
    return fmt::format("<div><dt>{}</dt><dd>{:.{}f} <small>{}</small></dd></div>", name, value,
                       digits, meaning);
}

std::string scores(const RenderScore& render) {
    std::string html = "<dl class=\"scores\">" + score("FLIP", render.flip, 3, "0: looks equal") +
                       score("SSIM", render.ssim, 3, "1: equal") +
                       score("GMSD", render.gmsd, 3, "0: equal edges") +
                       score("RMSE", render.rmse, 1, "of 255");
    if (render.zMax > 0.0 && std::isfinite(render.zMax))
        html += score("largest |z|", render.zMax, 1, "standard errors");
    return html + "</dl>";
}

std::string layButton(std::string_view act, std::string_view words, char key, PictureKeys keys) {
    const bool hasKey = keys == PictureKeys::all;
    return fmt::format(
        "<button type=\"button\" data-act=\"{}\" aria-pressed=\"{}\"{}>{}{}</button>", act,
        act == "side", hasKey ? fmt::format(" aria-keyshortcuts=\"{}\"", key) : "", words,
        hasKey ? fmt::format(" <kbd>{}</kbd>", static_cast<char>(key - 'a' + 'A')) : "");
}

std::string controls(std::string_view name, PictureKeys keys) {
    return fmt::format(
        "<div class=\"controls screen-only\" role=\"group\" aria-label=\"View of {}\">"
        "<span class=\"segments\">{}{}"
        "<button type=\"button\" data-act=\"blink\" aria-pressed=\"false\" "
        "aria-keyshortcuts=\"b\">Blink <kbd>B</kbd></button></span>"
        "<span class=\"segments\">"
        "<button type=\"button\" data-act=\"out\" aria-label=\"Zoom out\" aria-keyshortcuts=\"-\">"
        "&minus;</button><output>1&times;</output>"
        "<button type=\"button\" data-act=\"in\" aria-label=\"Zoom in\" aria-keyshortcuts=\"+\">+"
        "</button></span>"
        "<label class=\"wipe\">Expected <input type=\"range\" min=\"0\" max=\"100\" value=\"50\" "
        "aria-label=\"Share of the submitted picture, percent\"> Submitted</label>"
        "<span class=\"showing\" role=\"status\"></span>"
        "<span class=\"readout\" aria-hidden=\"true\"></span></div>",
        escapeHtml(name), layButton("side", "Side by side", 's', keys),
        layButton("over", "Slider", 'o', keys));
}

/// The pictures of one scene under one heading; the first two can be overlaid.
std::string viewer(const std::string& heading, const std::string& intro,
                   const std::vector<Shown>& pictures, std::string_view name, PictureKeys keys) {
    std::string html = fmt::format(
        "<section class=\"viewer\"><h3>{}</h3>{}{}<div class=\"stage of-{}\" tabindex=\"0\" "
        "role=\"group\" aria-label=\"{}: when zoomed, the arrow keys move all pictures\">",
        heading, intro, controls(name, keys), pictures.size(), escapeHtml(name));
    for (const Shown& shown : pictures)
        html += figure(shown);
    return html + "</div></section>";
}

/// One picture by itself.
std::string alone(const std::string& heading, const Shown& shown) {
    return fmt::format("<section class=\"alone\"><h3>{}</h3>{}</section>", heading, figure(shown));
}

Shown expectedPicture(const RenderScore& render, const Album& album) {
    return {album.addressOf(render.reference), "expected",
            render.scene + " as the model answer renders it", "Expected: the model answer"};
}

std::string ofRender(const RenderScore& render, const Album& album, PictureKeys keys) {
    const std::string heading = fmt::format("{} <span class=\"soft\">{} &times; {}</span>",
                                            escapeHtml(render.scene), render.width, render.height);
    const Shown submitted{album.addressOf(render.image), "submitted",
                          render.scene + " as this submission's code renders it",
                          "Submitted: rendered by this code"};
    if (submitted.source.empty()) return "";
    std::vector<Shown> pictures{expectedPicture(render, album), submitted};
    if (pictures.front().source.empty()) return alone(heading, submitted);
    if (const std::string flip = album.addressOf(render.errorMap); !flip.empty())
        pictures.push_back({flip, "flip",
                            render.scene + ": FLIP error map, bright where the two look different",
                            "FLIP: where they look different " + scale("magma", "0", "1")});
    if (const std::string z = album.addressOf(render.zMap); !z.empty())
        pictures.push_back(
            {z, "z", render.scene + ": signed z-map, blue where too dark, red where too bright",
             "z: darker or brighter than noise explains, in standard errors " +
                 scale("signed", "&minus;6", "+6")});
    return viewer(heading, scores(render), pictures, render.scene, keys);
}

/// The scene that a screenshot should show: the handout's scene of the attempted file; null if it
/// may be the other file's.
const RenderScore* screenshotScene(const SubmissionResult& result, const Exercise& exercise) {
    std::set<std::string_view> files;
    for (const TaskReport& task : result.tasks)
        if (task.state != TaskState::notAttempted) files.insert(exercise.fileOf(task.id));
    files.erase("");
    if (files.size() != 1) return nullptr;
    const auto scene = std::ranges::find_if(exercise.scenes, [&](const SceneEntry& entry) {
        return entry.isHandedIn && files.contains(entry.file);
    });
    if (scene == exercise.scenes.end()) return nullptr;
    const auto render = std::ranges::find(result.renders, scene->name, &RenderScore::scene);
    return render == result.renders.end() ? nullptr : &*render;
}

std::string ofScreenshot(const SubmissionResult& result, const Album& album, PictureKeys keys,
                         const Exercise& exercise) {
    const std::string file{kScreenshotFile};
    if (!album.has(file)) return "";
    const Shown submitted{album.addressOf(file), "submitted", "screenshot.png as handed in",
                          "Submitted: screenshot.png as handed in"};
    const RenderScore* scene = screenshotScene(result, exercise);
    if (scene == nullptr) return alone("screenshot.png", submitted);
    const Shown expected = expectedPicture(*scene, album);
    if (expected.source.empty()) return alone("screenshot.png", submitted);
    return viewer("screenshot.png", "", {expected, submitted}, "screenshot.png", keys);
}

/// What the pictures are for, and the keys where there is something to compare.
std::string intro(std::string_view pictures) {
    const bool isAlone = pictures.find("class=\"viewer\"") == std::string_view::npos;
    return std::string{
               "<p class=\"soft\">They explain and decide nothing: accepted readings of the "
               "handout differ in many pixels, and a mistake may differ in few."} +
           (isAlone
                ? ""
                : " <span class=\"screen-only\"><kbd>B</kbd> blinks between expected and "
                  "submitted, <kbd>O</kbd> lays one over the other with a slider, <kbd>S</kbd> "
                  "puts them side by side; <kbd>+</kbd> <kbd>&minus;</kbd> or a double click zoom "
                  "all pictures of a scene, dragging or the arrow keys move them.</span>") +
           "</p>";
}

}  // namespace

std::string picturesSection(const SubmissionResult& result, const Album& album, PictureKeys keys) {
    std::string html;
    for (const RenderScore& render : result.renders)
        html += ofRender(render, album, keys);
    html += ofScreenshot(result, album, keys, exerciseOf(result));
    if (html.empty()) return "";
    return "<section id=\"pictures\" aria-labelledby=\"pictures-head\">"
           "<h2 id=\"pictures-head\">Pictures</h2>" +
           (keys == PictureKeys::all ? intro(html) : "") + html + "</section>";
}

}  // namespace ticker::report
