#include <grader/base/WholeFile.h>
#include <grader/session/CodeView.h>
#include <grader/session/EarlierView.h>
#include <grader/session/SubmissionView.h>

#include <grader/exercise/Exercise.h>
#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/RepairSection.h>
#include <grader/report/ReportWords.h>
#include <grader/report/student/StudentView.h>
#include <grader/result/Names.h>

#include <fmt/core.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace ticker::session {
namespace {

namespace fs = std::filesystem;
using report::escapeHtml;

}  // namespace

std::string toldHtml(const SubmissionResult& result) {
    std::string html;
    for (const TaskReport& task : result.tasks)
        for (const Finding& finding : task.findings) {
            const std::string line = fmt::format(
                "<li><code>{}</code> {}</li>", escapeHtml(finding.id), escapeHtml(finding.message));
            const bool isNew = html.find(line) == std::string::npos;
            if (finding.severity != Severity::note && isNew) html += line;
        }
    return html.empty() ? "" : "<ul class=\"told\">" + html + "</ul>";
}

namespace {

std::string head(const SubmissionResult& result, const std::vector<store::Earlier>& earlier) {
    std::string html =
        fmt::format("<h1>{}</h1><p class=\"chips\">{}", escapeHtml(result.submission),
                    report::badge(toString(result.verdict), report::wordsFor(result.verdict)));
    for (const TaskReport& task : result.tasks)
        if (task.state != TaskState::notAttempted)
            html += fmt::format("<span>{} {}</span>", escapeHtml(task.title),
                                report::badge(report::kindOf(task), report::wordsFor(task)));
    return html +
           "<button type=\"button\" data-act=\"report\">Full report <kbd>o</kbd></button></p>" +
           earlierLine(result, earlier) + toldHtml(result);
}

std::string task(const SubmissionResult& result, const TaskReport& task,
                 const report::Album& album) {
    if (task.state == TaskState::notAttempted && task.findings.empty()) return "";
    std::string html = fmt::format("<section><h2>{} {}</h2>", escapeHtml(report::taskName(task)),
                                   report::badge(report::kindOf(task), report::wordsFor(task)));
    if (const TaskReport* before = report::saidBefore(result, task))
        return html +
               fmt::format("<p>The same as for {}.</p></section>", escapeHtml(before->title));
    const bool isSaid =
        std::ranges::find(task.findings, task.reason, &Finding::message) != task.findings.end();
    if (!task.reason.empty() && !isSaid)
        html += fmt::format("<p>{}</p>", escapeHtml(report::sentence(task.reason)));
    for (const Finding& finding : task.findings)
        html += report::findingCard(finding, album, "");
    html += report::repairSection(result, task);
    if (const std::string seen = report::figures(task.plots, task.rasters, album); !seen.empty())
        html += "<div class=\"card\"><div class=\"figures\">" + seen + "</div></div>";
    return html + "</section>";
}

std::string notices(const SubmissionResult& result) {
    std::string html;
    for (const std::string& notice : result.notices)
        html += fmt::format("<li>{}</li>", escapeHtml(notice));
    return html.empty() ? "" : "<section><h2>Notes</h2><ul>" + html + "</ul></section>";
}

std::vector<SourceText> sourcesIn(const fs::path& folder, const Exercise& exercise) {
    std::vector<SourceText> sources;
    for (const std::string& name : exercise.files()) {
        std::error_code error;
        if (!fs::is_regular_file(fs::symlink_status(folder / name, error))) continue;
        sources.push_back({name, readIfThere(folder / name).value_or("")});
    }
    return sources;
}

}  // namespace

std::string submissionHtml(SubmissionResult result, const fs::path& codeFolder,
                           const std::vector<store::Earlier>& earlier) {
    result.sources = sourcesIn(codeFolder, exerciseOf(result));
    const report::Album album{result, "of/" + result.submission + "/"};
    std::string findings = report::diagnosticsSection(result);
    for (const TaskReport& each : result.tasks)
        findings += task(result, each, album);
    const std::string pictures =
        report::picturesSection(result, album, report::PictureKeys::blinkAndZoom);
    const std::string work = "<div class=\"work\"><div class=\"findings\">" + findings +
                             notices(result) + "</div>" +
                             codeHtml(result.sources, markedLines(result)) + "</div>";
    // A submission that does not compile has no rendered picture, so its code comes first.
    return head(result, earlier) +
           (result.diagnostics.empty() ? pictures + work : work + pictures) +
           earlierHtml(result, codeFolder, earlier);
}

}  // namespace ticker::session
