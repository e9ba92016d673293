#include <grader/base/Utf8.h>
#include <grader/report/ReportWords.h>
#include <grader/report/student/StudentView.h>

#include <fmt/core.h>

#include <algorithm>

namespace ticker::report {
namespace {

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
