#include <grader/report/Words.h>

#include <fmt/core.h>

#include <cctype>

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
