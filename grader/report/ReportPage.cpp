#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>
#include <grader/report/ReportPage.h>
#include <grader/report/Words.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <algorithm>

namespace ticker::report {
namespace {

std::string anchor(const std::string& task) {
    std::string id = "task-" + task;
    std::replace(id.begin(), id.end(), '.', '-');
    return escapeHtml(id);
}

std::string headingOf(const TaskReport& task) {
    return escapeHtml(task.id == "screenshot" ? task.title : task.id + " " + task.title);
}

/// A task that nobody attempted needs no section of its own.
bool hasSection(const TaskReport& task) {
    return task.state != TaskState::notAttempted || !task.findings.empty();
}

const Finding* firstFail(const TaskReport& task) {
    for (const Finding& finding : task.findings)
        if (finding.severity == Severity::fail) return &finding;
    return nullptr;
}

std::string overviewItem(const TaskReport& task) {
    std::string html = "<li>";
    html += hasSection(task)
                ? fmt::format("<a href=\"#{}\">{}</a>", anchor(task.id), headingOf(task))
                : fmt::format("<strong>{}</strong>", headingOf(task));
    html += badge(toString(task.state), wordsFor(task.state));
    if (const Finding* finding = firstFail(task))
        html += fmt::format("<span class=\"reason mono\">{}</span>", escapeHtml(finding->id));
    else if (!task.reason.empty())
        html += fmt::format("<span class=\"reason\">{}</span>", escapeHtml(task.reason));
    return html + "</li>";
}

/// Why a person should look, where one should.
std::string reviewReasons(const SubmissionResult& result) {
    if (result.verdict != Verdict::needsReview) return "";
    std::string reasons;
    for (const TaskReport& task : result.tasks) {
        if (!task.needsReview && task.id != "screenshot") continue;
        if (task.state == TaskState::passed && !task.needsReview) continue;
        const Finding* finding = firstFail(task);
        const std::string reason = !task.reason.empty()    ? task.reason
                                   : finding != nullptr    ? finding->message
                                   : task.findings.empty() ? std::string{wordsFor(task.state)}
                                                           : task.findings.front().message;
        reasons += fmt::format("<li>{}: {}</li>", headingOf(task), escapeHtml(reason));
    }
    if (reasons.empty()) return "";
    return "<div class=\"why\"><p>Somebody should look at this before it counts:</p><ul>" +
           reasons + "</ul></div>";
}

std::string header(const SubmissionResult& result) {
    std::string html = fmt::format(
        "<header><p class=\"soft\">Tick 1*</p>"
        "<div class=\"verdict\"><h1>{}</h1>{}<span class=\"soft\">{:g} of {:g}</span></div>{}"
        "<ul class=\"tasks\">",
        escapeHtml(result.submission), badge(toString(result.verdict), wordsFor(result.verdict)),
        result.score, result.maxScore, reviewReasons(result));
    for (const TaskReport& task : result.tasks)
        html += overviewItem(task);
    return html + "</ul></header>";
}

std::string taskSections(const SubmissionResult& result) {
    std::string html;
    for (const TaskReport& task : result.tasks) {
        if (!hasSection(task)) continue;
        html += fmt::format("<section id=\"{}\"><h2>{} {}</h2>", anchor(task.id), headingOf(task),
                            badge(toString(task.state), wordsFor(task.state)));
        // Findings say it better.
        if (task.findings.empty() && !task.reason.empty())
            html += fmt::format("<p>{}</p>", escapeHtml(task.reason));
        for (const Finding& finding : task.findings)
            html += findingCard(finding);
        if (task.findings.empty() && task.state == TaskState::passed)
            html += "<p class=\"soft\">Nothing to remark.</p>";
        html += "</section>";
    }
    return html;
}

std::string seconds(double milliseconds) {
    return fmt::format("{:.1f} s", milliseconds / 1000.0);
}

std::string facts(const SubmissionResult& result) {
    std::string html = "<section id=\"facts\"><h2>How this was found</h2><dl class=\"facts\">";
    const auto fact = [&](const char* what, const std::string& value) {
        html += fmt::format("<dt>{}</dt><dd>{}</dd>", what, escapeHtml(value));
    };
    fact("Option", result.option);
    fact("Seed", std::to_string(result.seed));
    fact("Sandbox level", result.sandboxLevel);
    fact("Tool version", result.toolVersion);
    fact("Compiling", seconds(result.timing.compileMs));
    fact("Asking the program", seconds(result.timing.probeMs));
    fact("In all", seconds(result.timing.totalMs));
    for (const std::string& notice : result.notices)
        fact("Notice", notice);
    return html + "</dl></section>";
}

}  // namespace

std::string reportPage(const SubmissionResult& result) {
    return pageHead(fmt::format("{}: {}", result.submission, wordsFor(result.verdict)),
                    reportCss()) +
           header(result) + "<main id=\"main\">" + taskSections(result) +
           diagnosticsSection(result) + picturesSection(result) + facts(result) +
           "</main><footer><p>Proposed by ticker; a person decides.</p></footer><script>" +
           std::string{reportJs()} + "</script></body></html>\n";
}

}  // namespace ticker::report
