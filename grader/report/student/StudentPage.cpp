#include <grader/report/student/StudentPage.h>

#include <grader/report/Escape.h>
#include <grader/report/Markdown.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>
#include <grader/report/ReportWords.h>
#include <grader/result/Names.h>

#include <fmt/core.h>

#include <utility>

namespace ticker::report {
namespace {

std::string section(const StudentView& view, const TaskReport& task, const Album& album) {
    std::string html = fmt::format("<section><h2>{} {}</h2>", escapeHtml(headingOf(view, task)),
                                   badge(kindOf(task), wordsFor(task)));
    if (task.findings.empty() && !task.reason.empty())
        html += fmt::format("<p>{}</p>", escapeHtml(sentence(task.reason)));
    std::string seen = figures(task.plots, task.rasters, album);
    for (const Finding& finding : task.findings)
        html += findingCard(finding, album, std::exchange(seen, {}));
    return html + "</section>";
}

std::string comment(const StudentView& view) {
    if (view.comment().empty()) return "";
    return "<div class=\"why said\"><h2>Your ticker says</h2><div class=\"words\">" +
           markdownHtml(view.comment()) + "</div></div>";
}

std::string pictures(const SubmissionResult& result, const Album& album) {
    std::string html;
    for (const RenderScore& render : result.renders)
        html += fmt::format(
            R"(<figure class="submitted"><div class="frame"><img src="{}" alt="{}, from your code">)"
            "</div><figcaption>{}, from your code</figcaption></figure>",
            album.addressOf(render.image), escapeHtml(render.scene), escapeHtml(render.scene));
    return html.empty() ? "" : "<section class=\"alone\"><h2>Pictures</h2>" + html + "</section>";
}

}  // namespace

std::string studentPage(const StudentView& view) {
    const SubmissionResult& result = view.result();
    const Album album{result};
    std::string body = fmt::format(
        "<header><p class=\"soft crumbs\">{6}</p><div class=\"hero {0}\"><h1>{1}</h1>"
        "<p class=\"verdict\">{2}</p><p class=\"lead\">{3}</p></div>{4}</header>"
        "<main id=\"main\">{5}",
        toString(result.verdict), escapeHtml(result.submission),
        badge(toString(result.verdict), wordsFor(result.verdict)),
        escapeHtml(verdictSentence(view)), comment(view), notesSection(result, view.notes()),
        escapeHtml(view.exercise().title));
    for (const TaskReport& task : result.tasks)
        if (concernsStudent(task) && saidBefore(result, task) == nullptr)
            body += section(view, task, album);
    body += diagnosticsSection(result) + pictures(result, album) +
            fmt::format(
                "</main><footer><p>Should you doubt this result, tell the course staff its "
                "number: {}</p></footer>",
                view.appealNumber());
    return page(fmt::format("{}: {}", view.exercise().title, wordsFor(result.verdict)), reportCss(),
                reportJs(), body);
}

}  // namespace ticker::report
