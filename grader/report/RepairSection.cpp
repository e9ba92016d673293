#include <grader/report/Escape.h>
#include <grader/report/RepairSection.h>
#include <grader/report/ReportWords.h>

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace ticker::report {
namespace {

std::vector<const Repair*> repairsOf(const SubmissionResult& result, const std::string& task) {
    std::vector<const Repair*> found;
    if (!result.repairs) return found;
    for (const Repair& repair : *result.repairs)
        if (repair.task == task && repair.proven && !repair.edits.empty()) found.push_back(&repair);
    return found;
}

/// Each line of a text with a number and a sign before it.
std::string linesAs(const char* element, char sign, int first, std::string_view text) {
    std::string html;
    for (int number = first; !text.empty() || number == first; ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        html += fmt::format("<{0}><span class=\"number\">{1:>4} {2}</span> {3}</{0}>\n", element,
                            number, sign, escapeHtml(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return html;
}

std::string change(const Repair& repair) {
    std::string html;
    for (const RepairEdit& edit : repair.edits)
        html += fmt::format("<p>{}, line {}</p><pre class=\"source diff\"><code>{}{}</code></pre>",
                            escapeHtml(repair.file), edit.line,
                            linesAs("del", '-', edit.line, edit.from),
                            edit.to.empty() ? "" : linesAs("ins", '+', edit.line, edit.to));
    const std::string passes = repair.edits.size() > 1
                                   ? "Proven: together they pass all questions under three seeds."
                                   : "Proven: passes all questions under three seeds.";
    const std::string proof =
        repair.next.empty()
            ? passes
            : fmt::format("Proven under three seeds: with this, the next finding would be {}.",
                          escapeHtml(repair.next));
    return html + "<p class=\"soft\">" + proof + "</p>";
}

bool wasLookedFor(const SubmissionResult& result, const TaskReport& task) {
    const bool hasFailed = task.state == TaskState::failed;
    return result.repairs && hasFailed && task.id != "screenshot";
}

/// What the search said of a task, such as that its time ended: its notices, as sentences.
std::string remarksOf(const SubmissionResult& result, const TaskReport& task) {
    const std::string prefix = task.id + ": ";
    std::string remarks;
    for (const std::string& notice : result.notices) {
        if (!notice.starts_with(prefix) || notice.size() == prefix.size()) continue;
        remarks += " " + escapeHtml(sentence(notice.substr(prefix.size())));
    }
    return remarks;
}

}  // namespace

std::string repairSection(const SubmissionResult& result, const TaskReport& task) {
    const std::vector<const Repair*> repairs = repairsOf(result, task.id);
    if (repairs.empty())
        return wasLookedFor(result, task)
                   ? "<p class=\"soft\">No small edit of the code was found that mends this." +
                         remarksOf(result, task) + "</p>"
                   : "";
    std::string html =
        "<div class=\"card repair\"><h3>Where it stands</h3>" + change(*repairs.front());
    if (repairs.size() > 1) {
        html += fmt::format(
            "<details><summary>Other edits that are proven to mend it ({})"
            "</summary>",
            repairs.size() - 1);
        for (std::size_t i = 1; i < repairs.size(); ++i)
            html += change(*repairs[i]);
        html += "</details>";
    }
    return html + "</div>";
}

std::string agreedLine(const SubmissionResult& result, const std::string& task) {
    std::set<std::pair<std::string, int>> places;
    for (const Repair* repair : repairsOf(result, task))
        for (const RepairEdit& edit : repair->edits)
            places.insert({repair->next.empty() ? repair->file : "", edit.line});
    if (places.size() != 1 || places.begin()->first.empty()) return "";
    return fmt::format("An edit in line {} of {} mends this.", places.begin()->second,
                       places.begin()->first);
}

}  // namespace ticker::report
