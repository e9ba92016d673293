#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>
#include <grader/report/PageSources.h>
#include <grader/report/ReportPage.h>
#include <grader/report/Words.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <algorithm>
#include <cmath>

namespace ticker::report {
namespace {

std::string badge(std::string_view kind, std::string_view words) {
    return fmt::format(R"(<span class="badge {}">{}</span>)", kind, escapeHtml(words));
}

std::string anchor(const std::string& task) {
    std::string id = "task-" + task;
    std::replace(id.begin(), id.end(), '.', '-');
    return id;
}

std::string evidenceText(const EvidenceValue& value) {
    struct Visitor {
        std::string operator()(bool flag) const { return flag ? "yes" : "no"; }
        std::string operator()(double real) const { return fmt::format("{:.6g}", real); }
        std::string operator()(const std::string& text) const { return escapeHtml(text); }
        std::string operator()(const std::vector<double>& list) const {
            std::string text;
            for (const double real : list)
                text += fmt::format("{:.4g} ", real);
            return text;
        }
    };
    return std::visit(Visitor{}, value);
}

std::string evidenceTable(const Evidence& evidence) {
    if (evidence.empty()) return "";
    std::string html = "<details><summary>What was measured</summary><table class=\"evidence\">";
    for (const auto& [key, value] : evidence)
        html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"mono\">{}</td></tr>",
                            escapeHtml(spelledOut(key)), evidenceText(value));
    return html + "</table></details>";
}

std::string pictures(const Finding& finding) {
    if (finding.plots.empty() && finding.rasters.empty()) return "";
    std::string html = "<div class=\"pictures\">";
    for (const ScatterPlot& plot : finding.plots)
        html += fmt::format(
            "<figure>{}<figcaption>{} ({}); red: what was expected</figcaption></figure>",
            scatterSvg(plot), escapeHtml(plot.title), escapeHtml(plot.unit));
    for (const Raster& raster : finding.rasters)
        html += fmt::format(
            R"(<figure><img src="{}" alt="{}"><figcaption>{}</figcaption></figure>)",
            pngAddress(rasterPng(raster)), escapeHtml(raster.title), escapeHtml(raster.title));
    return html + "</div>";
}

std::string findingCard(const Finding& finding) {
    const std::string_view severity = toString(finding.severity);
    std::string html = fmt::format(
        R"(<article class="card {0}"><div class="finding-head">{1}<h3 class="mono">{2}</h3>)",
        severity, badge(severity, severity), escapeHtml(finding.id));
    if (!finding.section.empty())
        html += fmt::format("<span class=\"soft\">Handout: {}</span>", escapeHtml(finding.section));
    html += fmt::format("</div><p>{}</p>", escapeHtml(finding.message));
    if (!finding.hint.empty())
        html += fmt::format("<p class=\"hint\">{}</p>", escapeHtml(finding.hint));
    return html + pictures(finding) + evidenceTable(finding.evidence) + "</article>";
}

std::string taskOverview(const SubmissionResult& result) {
    std::string html = "<ul class=\"tasks\">";
    for (const TaskReport& task : result.tasks)
        html +=
            fmt::format("<li><a href=\"#{}\">{}</a><br>{} <span class=\"reason\">{}</span></li>",
                        anchor(task.id), escapeHtml(task.id + " " + task.title),
                        badge(toString(task.state), wordsFor(task.state)), escapeHtml(task.reason));
    return html + "</ul>";
}

std::string taskSections(const SubmissionResult& result) {
    std::string html;
    for (const TaskReport& task : result.tasks) {
        html += fmt::format("<section id=\"{0}\"><h2>{1} {2}</h2>", anchor(task.id),
                            escapeHtml(task.id + " " + task.title),
                            badge(toString(task.state), wordsFor(task.state)));
        if (!task.reason.empty()) html += fmt::format("<p>{}</p>", escapeHtml(task.reason));
        for (const Finding& finding : task.findings)
            html += findingCard(finding);
        if (task.findings.empty() && task.state == TaskState::passed)
            html += "<p class=\"soft\">Nothing to remark.</p>";
        html += "</section>";
    }
    return html;
}

const ResultPicture* pictureNamed(const SubmissionResult& result, const std::string& file) {
    for (const ResultPicture& picture : result.pictures)
        if (picture.file == file && !picture.png.empty()) return &picture;
    return nullptr;
}

std::string framed(const ResultPicture& picture, std::string_view kind, std::string_view caption) {
    return fmt::format(
        "<figure class=\"{}\"><div class=\"frame\"><img src=\"{}\" alt=\"{}\"></div>"
        "<figcaption>{}</figcaption></figure>",
        kind, pngAddress(picture.png), escapeHtml(picture.caption), caption);
}

std::string scores(const RenderScore& render) {
    return fmt::format("{} x {} pixels; FLIP {:.3f}, SSIM {:.3f}, GMSD {:.3f}, RMSE {:.2f}",
                       render.width, render.height, render.flip, render.ssim, render.gmsd,
                       render.rmse);
}

std::string comparison(const RenderScore& render, const ResultPicture& expected,
                       const ResultPicture& submitted) {
    return fmt::format(
        "<section class=\"compare\"><h3>{0}</h3><p class=\"soft\">{1}. Pictures explain; they do "
        "not decide.</p><div class=\"pair\">{2}{3}</div><div class=\"controls screen-only\">"
        "<button type=\"button\" data-act=\"over\" aria-pressed=\"false\">One over the other "
        "(O)</button><label>Wipe <input type=\"range\" min=\"0\" max=\"100\" value=\"50\"></label>"
        "<button type=\"button\" data-act=\"blink\" aria-pressed=\"false\">Blink (B)</button>"
        "<span><button type=\"button\" data-act=\"out\" aria-label=\"Zoom out\">&minus;</button> "
        "<output aria-live=\"polite\">1×</output> "
        "<button type=\"button\" data-act=\"in\" aria-label=\"Zoom in\">+</button></span></div>"
        "</section>",
        escapeHtml(render.scene), scores(render),
        framed(expected, "expected", "Expected (the model answer)"),
        framed(submitted, "submitted", "From this submission's code"));
}

std::string renders(const SubmissionResult& result) {
    std::string html;
    for (const RenderScore& render : result.renders) {
        const ResultPicture* expected = pictureNamed(result, render.reference);
        const ResultPicture* submitted = pictureNamed(result, render.image);
        if (expected != nullptr && submitted != nullptr)
            html += comparison(render, *expected, *submitted);
    }
    for (const ResultPicture& picture : result.pictures)
        if (picture.file == kScreenshotFile && !picture.png.empty())
            html += "<section class=\"compare-none\"><h3>screenshot.png as handed in</h3>" +
                    framed(picture, "screenshot", escapeHtml(picture.caption)) + "</section>";
    return html.empty() ? "" : "<section id=\"pictures\"><h2>Pictures</h2>" + html + "</section>";
}

std::string diagnostics(const SubmissionResult& result) {
    std::string html;
    for (const Diagnostics& said : result.diagnostics)
        if (!said.text.empty())
            html += fmt::format("<h3>{}</h3><pre>{}</pre>", escapeHtml(said.file),
                                escapeHtml(said.text));
    return html.empty() ? "" : "<section><h2>What the compiler said</h2>" + html + "</section>";
}

std::string facts(const SubmissionResult& result) {
    std::string html = "<section><h2>How this was found</h2><dl class=\"facts\">";
    const auto fact = [&](const char* what, const std::string& value) {
        html += fmt::format("<dt>{}</dt><dd>{}</dd>", what, escapeHtml(value));
    };
    fact("Seed", std::to_string(result.seed));
    fact("Sandbox level", result.sandboxLevel);
    fact("Tool version", result.toolVersion);
    fact("Compiling", fmt::format("{:.0f} ms", result.timing.compileMs));
    fact("Asking the program", fmt::format("{:.0f} ms", result.timing.probeMs));
    fact("In all", fmt::format("{:.0f} ms", result.timing.totalMs));
    for (const std::string& notice : result.notices)
        fact("Note", notice);
    return html + "</dl></section>";
}

}  // namespace

std::string reportPage(const SubmissionResult& result) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<title>{0}: {1}</title><style>{2}{3}</style></head><body>"
        "<header><p class=\"soft\">Tick 1*</p><div class=\"verdict\"><h1>{0}</h1>{4}"
        "<span class=\"soft\">{5:g} of {6:g}</span></div>{7}</header><main>{8}{9}{10}{11}</main>"
        "<footer>Proposed by ticker; a person "
        "decides.</footer><script>{12}</script></body></html>\n",
        escapeHtml(result.submission), wordsFor(result.verdict), commonCss(), reportCss(),
        badge(toString(result.verdict), wordsFor(result.verdict)), result.score, result.maxScore,
        taskOverview(result), taskSections(result), diagnostics(result), renders(result),
        facts(result), reportJs());
}

}  // namespace ticker::report
