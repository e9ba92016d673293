#include <grader/report/ClassPage.h>
#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>
#include <grader/report/Words.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace ticker::report {
namespace {

constexpr std::array kTasks{"T1", "T2.1", "T2.2", "screenshot"};

std::set<std::string> idsOf(const SubmissionResult& result) {
    std::set<std::string> ids;
    for (const TaskReport& task : result.tasks)
        for (const Finding& finding : task.findings)
            if (finding.severity != Severity::note) ids.insert(finding.id);
    return ids;
}

/// How many submissions there are of each kind.
struct Tally {
    std::map<Verdict, int> verdicts;
    std::map<std::string, int> findings;
};

Tally tallyOf(const std::vector<SubmissionResult>& results) {
    Tally tally;
    for (const SubmissionResult& result : results) {
        ++tally.verdicts[result.verdict];
        for (const std::string& id : idsOf(result))
            ++tally.findings[id];
    }
    return tally;
}

std::string counts(const Tally& tally) {
    std::string html = "<ul class=\"counts\">";
    for (const auto& [verdict, count] : tally.verdicts)
        html += fmt::format(
            "<li>{}</li>",
            badge(toString(verdict), verdict == Verdict::needsReview && count != 1
                                         ? fmt::format("{} need a look", count)
                                         : fmt::format("{} {}", count, wordsFor(verdict))));
    return html + "</ul>";
}

/// The findings, most frequent first, each a button that filters the table.
std::string findingCounts(const Tally& tally, std::size_t submissions) {
    if (tally.findings.empty()) return "";
    std::vector<std::pair<std::string, int>> ordered{tally.findings.begin(), tally.findings.end()};
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string html =
        "<section aria-labelledby=\"found\"><h2 id=\"found\">What was found</h2>"
        "<ul class=\"found\">";
    for (const auto& [id, count] : ordered)
        html += fmt::format(
            "<li><button type=\"button\" data-finding=\"{0}\" aria-pressed=\"false\" "
            "style=\"--share:{1:.1f}%\"><span class=\"mono\">{0}</span> "
            "<span class=\"soft\">{2} of {3}</span></button></li>",
            escapeHtml(id), 100.0 * count / static_cast<double>(submissions), count, submissions);
    return html + "</ul></section>";
}

std::string options(const Tally& tally) {
    std::string html = "<label>Verdict <select id=\"verdict\"><option value=\"\">all</option>";
    for (const auto& [verdict, count] : tally.verdicts)
        html +=
            fmt::format("<option value=\"{}\">{}</option>", toString(verdict), wordsFor(verdict));
    html +=
        "</select></label><label>Finding <select id=\"finding\"><option value=\"\">all</option>";
    for (const auto& [id, count] : tally.findings)
        html += fmt::format("<option value=\"{0}\">{0}</option>", escapeHtml(id));
    return html + "</select></label>";
}

std::string filters(const Tally& tally, std::size_t submissions) {
    return fmt::format(
        "<div class=\"filters screen-only\"><label>Search <input id=\"search\" type=\"search\">"
        "</label>{}<button type=\"button\" id=\"clear\">Show all</button>"
        "<span id=\"shown\" role=\"status\">{} submissions</span></div>",
        options(tally), submissions);
}

std::string stateCell(const SubmissionResult& result, std::string_view id) {
    for (const TaskReport& task : result.tasks)
        if (task.id == id && task.state != TaskState::notAttempted)
            return "<td>" + badge(toString(task.state), wordsFor(task.state)) + "</td>";
    return "<td class=\"soft\">&ndash;</td>";
}

std::string thumbnail(const SubmissionResult& result) {
    for (const RenderScore& render : result.renders)
        if (!render.image.empty())
            return fmt::format(
                R"(<img loading="lazy" width="96" height="72" src="{}" alt="{}, by {}">)",
                address(result.submission + "/" + render.image), escapeHtml(render.scene),
                escapeHtml(result.submission));
    return "";
}

std::string row(const SubmissionResult& result) {
    std::string ids;
    std::string list;
    for (const std::string& id : idsOf(result)) {
        ids += escapeHtml(id) + " ";
        list += fmt::format("<span class=\"id\">{}</span>", escapeHtml(id));
    }
    std::string html = fmt::format(
        "<tr data-verdict=\"{}\" data-findings=\"{}\"><th scope=\"row\" class=\"name\">"
        "<a href=\"{}\">{}</a></th>"
        "<td>{}</td>",
        toString(result.verdict), ids, address(result.submission + "/report.html"),
        escapeHtml(result.submission), badge(toString(result.verdict), wordsFor(result.verdict)));
    for (const char* task : kTasks)
        html += stateCell(result, task);
    return html + fmt::format("<td>{}</td><td>{}</td></tr>\n", list, thumbnail(result));
}

std::string table(const std::vector<SubmissionResult>& results) {
    std::string html =
        "<div class=\"scroll\"><table><caption>A heading sorts, a name opens the report; "
        "&ndash; means not attempted.</caption><thead><tr><th scope=\"col\"><button "
        "type=\"button\">Submission</button></th>"
        "<th scope=\"col\"><button type=\"button\">Verdict</button></th>";
    for (const char* task : kTasks)
        html += fmt::format("<th scope=\"col\"><button type=\"button\">{}</button></th>", task);
    html +=
        "<th scope=\"col\"><button type=\"button\">Findings</button></th>"
        "<th scope=\"col\">Picture</th></tr></thead><tbody>\n";
    for (const SubmissionResult& result : results)
        html += row(result);
    return html + "</tbody></table></div>";
}

}  // namespace

std::string classPage(const std::vector<SubmissionResult>& results) {
    const Tally tally = tallyOf(results);
    return pageHead(fmt::format("Tick 1*: {} submissions", results.size()), classCss()) +
           fmt::format(
               "<header><p class=\"soft\">Tick 1*</p><h1>{} submissions</h1>{}</header>"
               "<main id=\"main\">{}<section aria-labelledby=\"all\">"
               "<h2 id=\"all\">Submissions</h2>{}{}</section></main>"
               "<footer><p>Proposed by ticker; a person decides.</p></footer>",
               results.size(), counts(tally), findingCounts(tally, results.size()),
               filters(tally, results.size()), table(results)) +
           "<script>" + std::string{classJs()} + "</script></body></html>\n";
}

}  // namespace ticker::report
