#include <grader/report/Escape.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>
#include <grader/report/RepairSection.h>
#include <grader/report/ReportPage.h>
#include <grader/report/ReportWords.h>
#include <grader/report/student/StudentView.h>
#include <grader/result/AppealNumber.h>
#include <grader/result/Names.h>

#include <fmt/core.h>
#include <algorithm>
#include <utility>
#include <vector>

namespace ticker::report {
namespace {

std::string anchor(const std::string& task) {
    std::string id = "task-" + task;
    std::replace(id.begin(), id.end(), '.', '-');
    return escapeHtml(id);
}

const Finding* firstFail(const TaskReport& task) {
    for (const Finding& finding : task.findings)
        if (finding.severity == Severity::fail) return &finding;
    return nullptr;
}

/// Why a task did not pass, in a few words.
std::string shortReason(const TaskReport& task) {
    if (const Finding* finding = firstFail(task)) return std::string{wordsForFinding(finding->id)};
    return task.reason;
}

/// Groups tasks with equal texts.
class Grouped {
public:
    void add(const std::string& task, const std::string& what) {
        const auto known =
            std::ranges::find(groups_, what, [](const auto& group) { return group.second; });
        if (known != groups_.end())
            known->first.push_back(task);
        else
            groups_.push_back({{task}, what});
    }
    /// Pairs of task names and their common text.
    [[nodiscard]] const std::vector<std::pair<std::vector<std::string>, std::string>>& groups()
        const {
        return groups_;
    }

private:
    std::vector<std::pair<std::vector<std::string>, std::string>> groups_;
};

/// The verdict as a sentence.
std::string lead(const SubmissionResult& result) {
    if (result.verdict == Verdict::notGraded)
        return "Could not be graded, for reasons that are ours, not the student's.";
    std::string right;
    Grouped wrong;
    for (const TaskReport& task : result.tasks) {
        if (task.state == TaskState::notAttempted || task.id == "screenshot") continue;
        if (task.state == TaskState::passed)
            right += (right.empty() ? "Right: " : ", ") + taskName(task);
        else
            wrong.add(taskName(task), shortReason(task));
    }
    std::string text;
    for (const auto& [tasks, what] : wrong.groups()) {
        const bool isAll = tasks.size() > 1 && tasks.size() + 1 == result.tasks.size();
        text += fmt::format("{}{}", isAll ? sentence(what) : listed(tasks) + ": " + what,
                            what.ends_with('.') ? " " : ". ");
    }
    if (!right.empty()) text += right + ".";
    return text.empty() ? "No task was attempted." : text;
}

std::string overviewItem(const TaskReport& task) {
    const std::string name = escapeHtml(taskName(task));
    std::string html = fmt::format("<li class=\"{}\">", kindOf(task));
    html += concernsStudent(task) ? fmt::format("<a href=\"#{}\">{}</a>", anchor(task.id), name)
                                  : fmt::format("<strong>{}</strong>", name);
    html += badge(kindOf(task), wordsFor(task));
    if (const std::string reason = shortReason(task); !reason.empty())
        html += fmt::format("<span class=\"reason\">{}</span>", escapeHtml(sentence(reason)));
    return html + "</li>";
}

std::string reviewReason(const TaskReport& task) {
    if (!task.reason.empty()) return task.reason;
    if (const Finding* finding = firstFail(task)) return finding->message;
    return task.findings.empty() ? std::string{wordsFor(task)} : task.findings.front().message;
}

/// The reasons for review, if there are any.
std::string reviewReasons(const SubmissionResult& result) {
    if (result.verdict != Verdict::needsReview) return "";
    Grouped reasons;
    for (const TaskReport& task : result.tasks)
        if (task.needsReview ||
            (task.id == "screenshot" && task.state != TaskState::passed && !isNotChecked(task)))
            reasons.add(taskName(task), reviewReason(task));
    if (reasons.groups().empty()) return "";
    std::string html =
        "<section class=\"why\" aria-labelledby=\"why\"><h2 id=\"why\">A person should look "
        "before this counts</h2><ul>";
    for (const auto& [tasks, reason] : reasons.groups())
        html += fmt::format("<li><strong>{}:</strong> {}</li>", escapeHtml(listed(tasks)),
                            escapeHtml(sentence(reason)));
    return html + "</ul></section>";
}

std::string header(const SubmissionResult& result) {
    std::string html = fmt::format(
        "<header><p class=\"soft crumbs\">{7} report "
        "<a id=\"class\" href=\"../index.html\">All submissions</a></p>"
        "<div class=\"hero {0}\"><h1>{1}</h1><p class=\"verdict\">{2} <span>{3:g} of {4:g} "
        "point{6}</span>"
        "</p><p class=\"lead\">{5}</p></div></header>",
        toString(result.verdict), escapeHtml(result.submission),
        badge(toString(result.verdict), wordsFor(result.verdict)), result.score, result.maxScore,
        escapeHtml(lead(result)), result.maxScore == 1.0 ? "" : "s",
        escapeHtml(exerciseOf(result).title));
    return html;
}

std::string overview(const SubmissionResult& result) {
    std::string html = "<nav aria-label=\"Tasks\"><ul class=\"tasks\">";
    for (const TaskReport& task : result.tasks)
        html += overviewItem(task);
    return html + "</ul></nav>";
}

/// A task's plots are in the card of its first mistake, or in a card of their own. A mistake
/// without a picture links to those of the scenes.
std::string findingCards(const SubmissionResult& result, const TaskReport& task,
                         const Album& album) {
    std::string seen = figures(task.plots, task.rasters, album);
    std::string html;
    for (const Finding& finding : task.findings) {
        const bool first = &finding == firstFail(task);
        html += findingCard(finding, album, first ? seen : "");
        if (!first) continue;
        if (seen.empty() && finding.plots.empty() && finding.rasters.empty() &&
            !result.renders.empty())
            html += "<p><a href=\"#pictures\">See where the pictures differ</a></p>";
        seen.clear();
    }
    if (!seen.empty())
        html += "<div class=\"card\"><h3>What was seen</h3><div class=\"figures\">" + seen +
                "</div></div>";
    if (html.empty() && task.state == TaskState::passed)
        html = "<p class=\"soft\">Nothing to remark.</p>";
    return html;
}

std::string taskSection(const SubmissionResult& result, const TaskReport& task,
                        const Album& album) {
    std::string html = fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-head\"><h2 id=\"{0}-head\">{1} {2}"
        "</h2>",
        anchor(task.id), escapeHtml(taskName(task)), badge(kindOf(task), wordsFor(task)));
    if (const TaskReport* before = saidBefore(result, task))
        return html + fmt::format("<p>The same as for <a href=\"#{}\">{}</a>.</p></section>",
                                  anchor(before->id), escapeHtml(taskName(*before)));
    // Findings are clearer than the reason.
    if (task.findings.empty() && !task.reason.empty())
        html += fmt::format("<p>{}</p>", escapeHtml(sentence(task.reason)));
    return html + findingCards(result, task, album) + repairSection(result, task) + "</section>";
}

/// The tasks in their order, those that passed after the others: people look for what is wrong.
std::vector<const TaskReport*> worstFirst(const SubmissionResult& result) {
    std::vector<const TaskReport*> tasks;
    for (const TaskReport& task : result.tasks)
        tasks.push_back(&task);
    std::stable_partition(tasks.begin(), tasks.end(), [](const TaskReport* task) {
        return task->state != TaskState::passed || task->needsReview;
    });
    return tasks;
}

std::string seconds(double milliseconds) {
    return fmt::format("{:.1f} s", milliseconds / 1000.0);
}

std::string facts(const SubmissionResult& result) {
    std::string html =
        "<section id=\"facts\" aria-labelledby=\"facts-head\"><h2 id=\"facts-head\">How this was "
        "found</h2><dl class=\"facts\">";
    const auto fact = [&](const char* what, const std::string& value) {
        html += fmt::format("<dt>{}</dt><dd>{}</dd>", what, escapeHtml(value));
    };
    std::string scenes;
    for (const RenderScore& render : result.renders)
        scenes += fmt::format("{}{} at {} x {}", scenes.empty() ? "" : ", ", render.scene,
                              render.width, render.height);
    fact("Option", result.option);
    if (!scenes.empty()) fact("Scenes rendered", scenes);
    fact("Seed", std::to_string(result.seed));
    fact("Sandbox level", result.sandboxLevel);
    fact("Tool version", result.toolVersion);
    fact("Time", fmt::format("{} in all: {} to compile, {} in the submission's program",
                             seconds(result.timing.totalMs), seconds(result.timing.compileMs),
                             seconds(result.timing.probeMs)));
    for (const std::string& notice : result.notices)
        fact("Notice", notice);
    return html + "</dl></section>";
}

}  // namespace

std::string reportPage(const SubmissionResult& result) {
    const Album album{result};
    std::string body =
        header(result) + "<main id=\"main\">" + reviewReasons(result) + overview(result);
    for (const TaskReport* task : worstFirst(result))
        if (concernsStudent(*task)) body += taskSection(result, *task, album);
    body += diagnosticsSection(result) + picturesSection(result, album) + facts(result) +
            fmt::format(
                "</main><footer><p>Proposed by ticker; a person decides. Number for an "
                "appeal: {}</p></footer>",
                appealNumber(result));
    return page(fmt::format("{}: {}", result.submission, wordsFor(result.verdict)), reportCss(),
                reportJs(), body);
}

}  // namespace ticker::report
