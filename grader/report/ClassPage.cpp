#include <grader/report/ClassPage.h>
#include <grader/report/Escape.h>
#include <grader/report/PageSources.h>
#include <grader/report/Words.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

namespace ticker::report {
namespace {

constexpr std::array kTasks{"T1", "T2.1", "T2.2", "screenshot"};

/// A path of our own naming, for an attribute: everything unusual percent-encoded.
std::string address(std::string_view path) {
    std::string encoded;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || std::string_view{"-_.~/"}.find(c) != std::string_view::npos)
            encoded += c;
        else
            encoded += fmt::format("%{:02X}", byte);
    }
    return encoded;
}

std::string badge(std::string_view kind, std::string_view words) {
    return fmt::format(R"(<span class="badge {}">{}</span>)", kind, words);
}

std::set<std::string> idsOf(const SubmissionResult& result) {
    std::set<std::string> ids;
    for (const TaskReport& task : result.tasks)
        for (const Finding& finding : task.findings)
            if (finding.severity != Severity::note) ids.insert(finding.id);
    return ids;
}

std::string counts(const std::vector<SubmissionResult>& results) {
    std::map<Verdict, int> byVerdict;
    for (const SubmissionResult& result : results)
        ++byVerdict[result.verdict];
    std::string html = "<ul class=\"counts\">";
    for (const auto& [verdict, count] : byVerdict)
        html += fmt::format("<li>{}</li>", badge(toString(verdict),
                                                 fmt::format("{} {}", count, wordsFor(verdict))));
    return html + "</ul>";
}

std::string filters(const std::vector<SubmissionResult>& results) {
    std::map<std::string, int> byFinding;
    std::set<Verdict> verdicts;
    for (const SubmissionResult& result : results) {
        verdicts.insert(result.verdict);
        for (const std::string& id : idsOf(result))
            ++byFinding[id];
    }
    std::string html =
        "<div class=\"filters screen-only\"><label>Search <input id=\"search\" type=\"search\">"
        "</label><label>Verdict <select id=\"verdict\"><option value=\"\">all</option>";
    for (const Verdict verdict : verdicts)
        html +=
            fmt::format("<option value=\"{}\">{}</option>", toString(verdict), wordsFor(verdict));
    html +=
        "</select></label><label>Finding <select id=\"finding\"><option value=\"\">all</option>";
    for (const auto& [id, count] : byFinding)
        html += fmt::format("<option value=\"{0}\">{0}: {1} of {2}</option>", escapeHtml(id), count,
                            results.size());
    return html + fmt::format(
                      "</select></label><span id=\"shown\" role=\"status\">{} submissions"
                      "</span></div>",
                      results.size());
}

std::string stateCell(const SubmissionResult& result, std::string_view id) {
    for (const TaskReport& task : result.tasks)
        if (task.id == id)
            return "<td>" + badge(toString(task.state), wordsFor(task.state)) + "</td>";
    return "<td></td>";
}

std::string thumbnail(const SubmissionResult& result) {
    for (const RenderScore& render : result.renders)
        if (!render.image.empty())
            return fmt::format(
                R"(<img loading="lazy" src="{}" alt="{} as rendered by this submission">)",
                address(result.submission + "/" + render.image), escapeHtml(render.scene));
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
        "<tr data-verdict=\"{}\" data-findings=\"{}\"><td class=\"name\"><a href=\"{}\">{}</a></td>"
        "<td>{}</td>",
        toString(result.verdict), ids, address(result.submission + "/report.html"),
        escapeHtml(result.submission), badge(toString(result.verdict), wordsFor(result.verdict)));
    for (const char* task : kTasks)
        html += stateCell(result, task);
    return html + fmt::format("<td>{}</td><td>{}</td></tr>\n", list, thumbnail(result));
}

std::string table(const std::vector<SubmissionResult>& results) {
    std::string html =
        "<div class=\"scroll\"><table><caption>Click a heading to sort, a name to read the report."
        "</caption><thead><tr><th scope=\"col\"><button type=\"button\">Submission</button></th>"
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
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<title>Tick 1*: {0} submissions</title><style>{1}{2}</style></head><body>"
        "<header><p class=\"soft\">Tick 1*</p><h1>{0} submissions</h1>{3}</header>"
        "<main>{4}{5}</main><footer>Proposed by ticker; a person decides.</footer>"
        "<script>{6}</script></body></html>\n",
        results.size(), commonCss(), classCss(), counts(results), filters(results), table(results),
        classJs());
}

}  // namespace ticker::report
