#include <grader/report/ReportWords.h>

#include <grader/result/Names.h>
#include <grader/tasks/FindingTables.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace ticker::report {

std::string_view wordsFor(Verdict verdict) {
    switch (verdict) {
        case Verdict::awarded:
            return "awarded";
        case Verdict::notAwarded:
            return "not awarded";
        case Verdict::needsReview:
            return "needs a look";
        case Verdict::notGraded:
            return "not graded";
    }
    return "";
}

std::string_view wordsFor(TaskState state) {
    switch (state) {
        case TaskState::passed:
            return "passed";
        case TaskState::failed:
            return "failed";
        case TaskState::notAttempted:
            return "not attempted";
        case TaskState::blocked:
            return "blocked";
        case TaskState::notGraded:
            return "not graded";
    }
    return "";
}

std::string_view wordsFor(const TaskReport& task) {
    return isNotChecked(task) ? "not checked" : wordsFor(task.state);
}

std::string_view kindOf(const TaskReport& task) {
    return isNotChecked(task) ? "notChecked" : toString(task.state);
}

std::string_view wordsFor(Severity severity) {
    switch (severity) {
        case Severity::fail:
            return "mistake";
        case Severity::warn:
            return "warning";
        case Severity::note:
            return "note";
    }
    return "";
}

std::string_view wordsForFinding(std::string_view id) {
    const FindingText* text = tasks::findText(id);
    return text != nullptr ? text->words : id;
}

const TaskReport* saidBefore(const SubmissionResult& result, const TaskReport& task) {
    const bool isSilent = task.findings.empty() && task.reason.empty();
    if (isSilent || task.state == TaskState::notAttempted) return nullptr;
    const auto isSame = [&](const TaskReport& other) {
        return other.state == task.state && other.reason == task.reason &&
               std::ranges::equal(other.findings, task.findings,
                                  [](const Finding& a, const Finding& b) {
                                      return a.id == b.id && a.message == b.message;
                                  });
    };
    const TaskReport* first = std::to_address(std::ranges::find_if(result.tasks, isSame));
    return first < &task ? first : nullptr;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string counted(std::size_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string sentence(std::string_view text) {
    std::string result{text};
    if (!result.empty())
        result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    return result;
}

std::string spelledOut(std::string_view key) {
    std::string words;
    for (const char c : key) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isupper(byte) != 0 && !words.empty()) words += ' ';
        words += static_cast<char>(std::tolower(byte));
    }
    return words;
}

}  // namespace ticker::report
