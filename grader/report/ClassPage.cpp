#include <grader/report/ClassPage.h>
#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>
#include <grader/report/ReportWords.h>
#include <grader/result/Names.h>
#include <grader/result/Tally.h>

#include <fmt/core.h>
#include <algorithm>
#include <cstddef>

namespace ticker::report {
namespace {

/// The verdicts as one bar; each part is a button that filters the table.
std::string verdictBar(const Tally& tally) {
    if (tally.verdicts.empty()) return "";
    std::string html = "<ul class=\"bar\">";
    for (const auto& [verdict, count] : tally.verdicts)
        html += fmt::format(
            "<li style=\"flex-grow:{0}\"><button type=\"button\" class=\"{1}\" "
            "data-verdict=\"{1}\" "
            "aria-pressed=\"false\"><strong>{0}</strong> {2}</button></li>",
            count, toString(verdict),
            verdict == Verdict::needsReview && count != 1 ? "need a look" : wordsFor(verdict));
    return html + "</ul>";
}

/// For each task the numbers of submissions that attempted and passed it.
std::string taskCounts(const Tally& tally) {
    std::string html;
    for (const auto& [task, count] : tally.tasks)
        if (count.tried > 0)
            html += fmt::format(
                "<div><dt>{0}</dt><dd><span class=\"meter\" style=\"--share:{1:.1f}%\"></span>{2} "
                "of "
                "{3} passed</dd></div>",
                escapeHtml(task), 100.0 * count.passed / count.tried, count.passed, count.tried);
    return html.empty() ? html : "<dl class=\"rates\">" + html + "</dl>";
}

/// The findings, the most frequent first; each is a button that filters the table.
std::string findingCounts(const Tally& tally, std::size_t submissions) {
    if (tally.findings.empty()) return "";
    std::string html =
        "<section aria-labelledby=\"found\"><h2 id=\"found\">What was found</h2>"
        "<ul class=\"found\">";
    for (const auto& [id, count] : tally.findings)
        html += fmt::format(
            "<li><button type=\"button\" data-finding=\"{0}\" aria-pressed=\"false\" "
            "style=\"--share:{1:.1f}%\"><span class=\"count\">{2} of {3}</span> "
            "<span class=\"words\">{4}</span> <span class=\"mono soft\">{0}</span></button></li>",
            escapeHtml(id), 100.0 * count / static_cast<double>(submissions), count, submissions,
            escapeHtml(wordsForFinding(id)));
    return html + "</ul></section>";
}

std::string filters(const Tally& tally, std::size_t submissions) {
    std::string html =
        "<div class=\"filters screen-only\" role=\"search\"><label>Search "
        "<input id=\"search\" type=\"search\" aria-keyshortcuts=\"/\"></label>"
        "<label>Verdict <select id=\"verdict\"><option value=\"\">all</option>";
    for (const auto& [verdict, count] : tally.verdicts)
        html +=
            fmt::format("<option value=\"{}\">{}</option>", toString(verdict), wordsFor(verdict));
    html +=
        "</select></label><label>Finding <select id=\"finding\"><option value=\"\">all</option>";
    for (const auto& [id, count] : tally.findings)
        html += fmt::format("<option value=\"{0}\">{0}</option>", escapeHtml(id));
    return html + fmt::format(
                      "</select></label><button type=\"button\" id=\"clear\">Show all"
                      "</button><span id=\"shown\" role=\"status\">{}</span>"
                      "</div>",
                      counted(submissions, "submission"));
}

std::string stateCell(const SubmissionResult& result, std::string_view id) {
    for (const TaskReport& task : result.tasks)
        if (task.id == id && task.state != TaskState::notAttempted)
            return fmt::format("<td data-key=\"{}\">{}</td>", static_cast<int>(task.state),
                               badge(kindOf(task), wordsFor(task)));
    return "<td data-key=\"9\" class=\"soft\">&ndash;</td>";
}

std::string thumbnail(const SubmissionResult& result, const std::string& file,
                      std::string_view what) {
    if (!file.starts_with("images/")) return "";
    return fmt::format(
        R"(<img loading="lazy" width="96" height="72" src="{}" alt="{}, {}" title="{}">)",
        address(result.submission + "/" + file), escapeHtml(what), escapeHtml(result.submission),
        escapeHtml(what));
}

/// Small pictures of the renders and the screenshot.
std::string thumbnails(const SubmissionResult& result) {
    std::string html;
    if (!result.renders.empty())
        html += thumbnail(result, result.renders.front().image,
                          result.renders.front().scene + " as this code renders it");
    for (const ResultPicture& picture : result.pictures)
        if (picture.file == kScreenshotFile)
            html += thumbnail(result, picture.file, "screenshot.png as handed in");
    return html;
}

/// What was decided in a session, shown below the proposal; empty if nothing was.
std::string decided(const std::vector<Decision>& decisions, const SubmissionResult& result) {
    const auto found = std::ranges::find(decisions, result.submission, &Decision::submission);
    if (found == decisions.end() || found->ruling == Ruling::undecided) return "";
    const bool isStale = !found->files.empty() && found->files != result.inputs.files;
    return fmt::format("<span class=\"ruled soft\">decided: {}{}</span>",
                       found->ruling == Ruling::awarded ? "awarded" : "not yet",
                       isStale ? ", about an earlier hand-in" : "");
}

std::string row(const SubmissionResult& result, const std::vector<std::string>& tasks,
                const std::vector<Decision>& decisions) {
    std::string ids;
    std::string list;
    for (const std::string& id : findingIds(result)) {
        ids += escapeHtml(id) + " ";
        list += fmt::format("<li title=\"{}\">{}</li>", escapeHtml(id),
                            escapeHtml(wordsForFinding(id)));
    }
    if (!list.empty()) list = "<ul class=\"ids\">" + list + "</ul>";
    std::string html = fmt::format(
        "<tr data-verdict=\"{0}\" data-findings=\"{1}\"><th scope=\"row\" class=\"name\">"
        "<a href=\"{2}#class\">{3}</a> <a class=\"student soft\" href=\"{6}\" "
        "aria-label=\"for the student: {3}\">for the student</a></th>"
        "<td data-key=\"{4}\">{5}{7}</td>",
        toString(result.verdict), ids, address(result.submission + "/report.html"),
        escapeHtml(result.submission), static_cast<int>(result.verdict),
        badge(toString(result.verdict), wordsFor(result.verdict)),
        address(result.submission + "/student.html"), decided(decisions, result));
    for (const std::string& task : tasks)
        html += stateCell(result, task);
    return html +
           fmt::format("<td>{}</td><td class=\"thumbs\">{}</td></tr>\n", list, thumbnails(result));
}

/// The words of the session's summary; empty before the first decision.
std::string decidedCounts(const std::vector<Decision>& decisions, std::size_t submissions) {
    const auto number = [&](Ruling ruling) {
        return static_cast<std::size_t>(std::ranges::count(decisions, ruling, &Decision::ruling));
    };
    const std::size_t awarded = number(Ruling::awarded);
    const std::size_t notYet = number(Ruling::notYet);
    if (awarded + notYet == 0) return "";
    return fmt::format(
        "<p>Decided: <span id=\"decided\">{} awarded, {} not yet, {} undecided of {}.</span></p>",
        awarded, notYet, submissions - awarded - notYet, submissions);
}

std::string heading(std::string_view text) {
    return fmt::format("<th scope=\"col\"><button type=\"button\">{}</button></th>", text);
}

std::string table(const std::vector<SubmissionResult>& results,
                  const std::vector<std::string>& tasks, const std::vector<Decision>& decisions) {
    std::string html =
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table of submissions\">"
        "<table><caption>A heading sorts, a name opens the report for staff; &ndash; means not "
        "attempted."
        "</caption><thead><tr>" +
        heading("Submission") + heading("Verdict");
    for (const std::string& task : tasks)
        html += heading(sentence(task));
    html += heading("What was found") + "<th scope=\"col\">Pictures</th></tr></thead><tbody>\n";
    for (const SubmissionResult& result : results)
        html += row(result, tasks, decisions);
    return html + "</tbody></table></div>";
}

}  // namespace

std::string classPage(const std::vector<SubmissionResult>& results, const Exercise& exercise,
                      const std::vector<Decision>& decisions) {
    const Tally tally = tallyOf(results);
    const std::string title = counted(results.size(), "submission");
    return page(exercise.title + ": " + title, classCss(), classJs(),
                fmt::format("<header><p class=\"soft crumbs\">{}</p><h1>{}</h1>{}{}{}</header>"
                            "<main id=\"main\">{}<section aria-labelledby=\"all\">"
                            "<h2 id=\"all\">Submissions</h2>{}{}</section></main>"
                            "<footer><p>Proposed by ticker; a person decides.</p></footer>",
                            escapeHtml(exercise.title), title, verdictBar(tally),
                            decidedCounts(decisions, results.size()), taskCounts(tally),
                            findingCounts(tally, results.size()), filters(tally, results.size()),
                            table(results, exercise.reported(), decisions)));
}

std::string classPage(const std::vector<SubmissionResult>& results,
                      const std::vector<Decision>& decisions) {
    return classPage(results, exerciseOf(results), decisions);
}

}  // namespace ticker::report
