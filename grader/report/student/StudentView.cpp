#include <grader/report/student/StudentView.h>

#include <grader/report/Escape.h>
#include <grader/report/RepairSection.h>
#include <grader/report/ReportWords.h>
#include <grader/result/AppealNumber.h>

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace ticker::report {
namespace {

bool isShown(const Finding& finding, const StudentPolicy& policy) {
    switch (finding.severity) {
        case Severity::fail:
            return true;
        case Severity::warn:
            return policy.warnings;
        case Severity::note:
            return policy.notes;
    }
    return false;
}

/// Leaves at most what the student's code did at one question: a drawing without the rays that were
/// expected and without the expected normals, and no points.
void withhold(std::vector<ScatterPlot>& plots, const StudentPolicy& policy) {
    std::erase_if(plots, [&](const ScatterPlot& plot) { return !policy.rays || !plot.drawing; });
    for (ScatterPlot& plot : plots) {
        std::erase_if(plot.drawing->rays, [](const RayDrawing::Ray& ray) {
            return ray.kind == RayDrawing::Kind::expected;
        });
        for (RayDrawing::Normal& normal : plot.drawing->normals)
            normal.expected.reset();
        plot.points.clear();
        plot.expectedHalfWidth = plot.otherHalfWidth = 0.0;
    }
}

/// @param isAllowed  Its hint is shown even if the policy withholds hints.
void withhold(Finding& finding, const StudentPolicy& policy, bool isAllowed) {
    withhold(finding.plots, policy);
    finding.rasters.clear();
    if (!policy.hints && !isAllowed) finding.hint.clear();
    std::erase_if(finding.evidence, [&](const auto& entry) {
        return std::ranges::find(policy.evidence, entry.first) == policy.evidence.end();
    });
}

/// The line that mends a task, in the words of its first failure. @param whole  Everything known.
void sayLine(TaskReport& task, const SubmissionResult& whole, const StudentPolicy& policy) {
    if (policy.repairs == StudentPolicy::Repairs::off) return;
    const std::string line = agreedLine(whole, task.id);
    const auto said = std::ranges::find(task.findings, Severity::fail, &Finding::severity);
    if (!line.empty() && said != task.findings.end()) said->message += " " + line;
}

/// @param isMended  The report names a line that mends the task, so that its hint may be shown.
void withhold(TaskReport& task, const StudentPolicy& policy, bool isMended) {
    // The reason of a notGraded task may describe this machine.
    if (task.state == TaskState::notGraded)
        task.reason = "could not be graded, for reasons that are not yours";
    std::erase_if(task.findings, [&](const Finding& finding) { return !isShown(finding, policy); });
    for (Finding& finding : task.findings)
        withhold(finding, policy, isMended && finding.severity == Severity::fail);
    withhold(task.plots, policy);
    task.rasters.clear();
}

bool hasBytes(const SubmissionResult& result, const std::string& file) {
    return std::ranges::any_of(result.pictures, [&](const ResultPicture& picture) {
        return picture.file == file && !picture.png.empty();
    });
}

void withholdPictures(SubmissionResult& result, const StudentPolicy& policy) {
    // Students' pages are stored elsewhere: pictures are embedded or left out.
    std::erase_if(result.renders, [&](const RenderScore& render) {
        return !policy.ownPictures || !hasBytes(result, render.image);
    });
    for (RenderScore& render : result.renders) {
        render.reference.clear();
        render.errorMap.clear();
        render.zMap.clear();
    }
    std::erase_if(result.pictures, [&](const ResultPicture& picture) {
        return std::ranges::none_of(result.renders, [&](const RenderScore& render) {
            return render.image == picture.file;
        });
    });
}

std::string compilerText(const StudentView& view, const TaskReport& task) {
    if (task.state != TaskState::blocked) return "";
    for (const Diagnostics& said : view.result().diagnostics)
        if (said.file == view.exercise().fileOf(task.id) && !said.text.empty())
            return fmt::format("What the compiler said about {}:\n{}\n", said.file, said.text);
    return "";
}

std::string findingText(const Finding& finding) {
    std::string text =
        fmt::format("{} ({}): {}\n", wordsFor(finding.severity), finding.id, finding.message);
    if (!finding.hint.empty()) text += fmt::format("Hint: {}\n", finding.hint);
    if (!finding.section.empty()) text += fmt::format("Handout: {}\n", finding.section);
    return text;
}

/// The rubric's condition: "A, or B and C together".
std::string ruleOf(const std::vector<Option>& options) {
    std::string ways;
    for (const Option& option : options)
        ways += fmt::format("{}{}{}", ways.empty() ? "" : ", or ", listed(option.tasks),
                            option.tasks.size() > 1 ? " together" : "");
    if (ways.empty()) return "";
    return (options.size() > 1 ? " One option is enough: " : " It takes ") + ways + ".";
}

/// " Edit One.cpp (A) or Other.cpp (B and C)."
std::string filesOf(const std::vector<Option>& options, const Exercise& exercise) {
    std::string text;
    for (const Option& option : options)
        text += fmt::format("{}{} ({})", text.empty() ? " Edit " : " or ",
                            exercise.fileOf(option.tasks.front()), listed(option.tasks));
    return text.empty() ? text : text + ".";
}

std::string sentenceFor(const StudentView& view) {
    const SubmissionResult& result = view.result();
    if (result.verdict == Verdict::awarded && view.proposed() == Verdict::notAwarded)
        return "Tick awarded by your ticker, against the automatic check. What the check says "
               "below does not take it back.";
    if (result.verdict == Verdict::notAwarded && view.proposed() == Verdict::awarded)
        return "No tick yet. Your ticker decided so, although the automatic check below passed.";
    switch (result.verdict) {
        case Verdict::awarded:
            return "Tick awarded.";
        case Verdict::notAwarded:
            return std::ranges::any_of(result.tasks, concernsStudent)
                       ? "No tick yet." + ruleOf(result.options)
                       : "No tick yet: no task was worked on." +
                             filesOf(result.options, view.exercise());
        case Verdict::needsReview:
            return "A person will look at this before it counts.";
        case Verdict::notGraded:
            return "This could not be graded, for reasons that are not yours. Please tell the "
                   "course staff.";
    }
    return "";
}

std::string withoutNewlinesAtEnd(std::string text) {
    while (text.ends_with('\n'))
        text.pop_back();
    return text;
}

}  // namespace

StudentView::StudentView(SubmissionResult result, const StudentPolicy& policy, std::string comment,
                         std::optional<Verdict> proposed, const Exercise& exercise,
                         std::vector<LineNote> notes)
    : result_(std::move(result)),
      comment_(std::move(comment)),
      notes_(std::move(notes)),
      proposed_(proposed.value_or(result_.verdict)),
      appealNumber_(ticker::appealNumber(result_)),
      exercise_(&exercise) {
    result_.seed = 0;
    for (TaskReport& task : result_.tasks) {
        const bool isMended = policy.repairs == StudentPolicy::Repairs::lineAndHint &&
                              !agreedLine(result_, task.id).empty();
        sayLine(task, result_, policy);
        withhold(task, policy, isMended);
    }
    result_.repairs.reset();
    withholdPictures(result_, policy);
    if (!policy.compilerOutput) result_.diagnostics.clear();
}

StudentView::StudentView(const SubmissionResult& result, const StudentPolicy& policy,
                         std::string comment, std::optional<Verdict> proposed,
                         std::vector<LineNote> notes)
    : StudentView(result, policy, std::move(comment), proposed, exerciseOf(result),
                  std::move(notes)) {}

bool concernsStudent(const TaskReport& task) {
    return task.state != TaskState::notAttempted || !task.findings.empty();
}

bool isDecided(const TaskReport& task) {
    return !task.needsReview && task.state != TaskState::notGraded && !isNotChecked(task);
}

bool hasScore(const SubmissionResult& result) {
    return result.verdict == Verdict::awarded || result.verdict == Verdict::notAwarded;
}

std::string taskName(const TaskReport& task) {
    return task.id == kScreenshotTask ? "Screenshot" : task.id + " " + task.title;
}

std::string shortText(const StudentView& view, const TaskReport& task) {
    if (const TaskReport* before = saidBefore(view.result(), task))
        return fmt::format("The same as for {}.", taskName(*before));
    std::string text;
    if (task.findings.empty() && !task.reason.empty()) text += task.reason + "\n";
    for (const Finding& finding : task.findings)
        text += (text.empty() ? "" : "\n") + findingText(finding);
    return withoutNewlinesAtEnd(cleanText(text.empty() ? std::string{wordsFor(task)} : text));
}

std::string taskText(const StudentView& view, const TaskReport& task) {
    const std::string text = shortText(view, task);
    if (saidBefore(view.result(), task) != nullptr) return text;
    return withoutNewlinesAtEnd(text + "\n" + cleanText(compilerText(view, task)));
}

std::string headingOf(const StudentView& view, const TaskReport& task) {
    std::vector<std::string> names;
    for (const TaskReport& other : view.result().tasks)
        if (&other == &task || saidBefore(view.result(), other) == &task)
            names.push_back(taskName(other));
    return listed(names);
}

std::string verdictSentence(const StudentView& view) {
    return sentenceFor(view);
}

std::string verdictText(const StudentView& view) {
    std::string text = sentenceFor(view);
    if (!view.comment().empty()) text += fmt::format("\nYour ticker says: {}", view.comment());
    for (const LineNote& note : view.notes())
        text +=
            fmt::format("\nAbout {}, line {}: {}\n{}", note.file, note.line, note.code, note.text);
    return cleanText(text);
}

std::string tasksText(const StudentView& view) {
    std::string text;
    for (const TaskReport& task : view.result().tasks) {
        if (!concernsStudent(task) || saidBefore(view.result(), task) != nullptr) continue;
        text += fmt::format("\n{}, {}\n", headingOf(view, task), wordsFor(task));
        if (const std::string said = taskText(view, task); said != wordsFor(task))
            text += said + "\n";
    }
    return cleanText(text);
}

std::string wholeText(const StudentView& view) {
    return withoutNewlinesAtEnd(verdictText(view) + "\n" + tasksText(view));
}

}  // namespace ticker::report
