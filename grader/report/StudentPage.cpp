#include <grader/report/StudentPage.h>

#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>
#include <grader/report/Words.h>
#include <grader/result/Names.h>

#include <fmt/core.h>

namespace ticker::report {
namespace {

std::string section(const TaskReport& task) {
    std::string html = fmt::format("<section><h2>{} {}</h2>", escapeHtml(taskName(task)),
                                   badge(toString(task.state), wordsFor(task.state)));
    if (task.findings.empty() && !task.reason.empty())
        html += fmt::format("<p>{}</p>", escapeHtml(task.reason));
    for (const Finding& finding : task.findings)
        html += findingCard(finding);
    return html + "</section>";
}

std::string pictures(const SubmissionResult& result) {
    std::string html;
    for (const RenderScore& render : result.renders)
        for (const ResultPicture& picture : result.pictures)
            if (picture.file == render.image)
                html += fmt::format(
                    R"(<figure class="submitted"><div class="frame"><img src="{}" alt="{}"></div>)"
                    "<figcaption>{}, from your code</figcaption></figure>",
                    pngAddress(picture.png), escapeHtml(picture.caption), escapeHtml(render.scene));
    return html.empty() ? "" : "<section><h2>Pictures</h2>" + html + "</section>";
}

}  // namespace

std::string studentPage(const StudentView& view) {
    const SubmissionResult& result = view.result();
    std::string html = pageHead(fmt::format("Tick 1*: {}", wordsFor(result.verdict)), reportCss());
    html += fmt::format(
        "<header><p class=\"soft\">Tick 1*</p><div class=\"verdict\"><h1>{}</h1>{}</div>"
        "<p>{}</p></header><main id=\"main\">",
        escapeHtml(result.submission), badge(toString(result.verdict), wordsFor(result.verdict)),
        escapeHtml(verdictText(view)));
    for (const TaskReport& task : result.tasks)
        if (concernsStudent(task)) html += section(task);
    return html + diagnosticsSection(result) + pictures(result) + "</main></body></html>\n";
}

}  // namespace ticker::report
