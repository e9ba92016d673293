#include <grader/report/PlatformFormats.h>

#include <grader/report/Escape.h>

#include <fmt/core.h>

#include <array>
#include <string_view>

namespace ticker::report {
namespace {

enum class Outcome { passed, failed, skipped, error };

struct Case {
    std::string name;
    Outcome outcome = Outcome::passed;
    std::string text;  ///< empty where there is nothing to say
};

Outcome outcomeOf(const TaskReport& task) {
    if (task.needsReview) return Outcome::skipped;
    switch (task.state) {
        case TaskState::passed:
            return Outcome::passed;
        case TaskState::failed:
        case TaskState::blocked:
            return Outcome::failed;
        case TaskState::notAttempted:
            return Outcome::skipped;
        case TaskState::notGraded:
            break;
    }
    return Outcome::error;
}

Outcome outcomeOf(Verdict verdict) {
    switch (verdict) {
        case Verdict::awarded:
            return Outcome::passed;
        case Verdict::notAwarded:
            return Outcome::failed;
        case Verdict::needsReview:
            return Outcome::skipped;
        case Verdict::notGraded:
            break;
    }
    return Outcome::error;
}

/// Readers turn newlines of an attribute into blanks unless they are written as references.
std::string attribute(std::string_view text) {
    std::string escaped;
    for (const char c : escapeHtml(text)) {
        if (c == '\n')
            escaped += "&#10;";
        else if (c == '\t')
            escaped += "&#9;";
        else
            escaped += c;
    }
    return escaped;
}

/// Artemis and Jenkins show the attribute, GitLab shows the body: both hold everything.
std::string caseXml(const Case& test) {
    const auto with = [&](std::string_view element) {
        return fmt::format("      <{0} message=\"{1}\" type=\"ticker\">{2}</{0}>\n", element,
                           attribute(test.text), escapeHtml(test.text));
    };
    std::string inside;
    switch (test.outcome) {
        case Outcome::passed:
            if (!test.text.empty())
                inside = fmt::format("      <system-out>{}</system-out>\n", escapeHtml(test.text));
            break;
        case Outcome::failed:
            inside = with("failure");
            break;
        case Outcome::error:
            inside = with("error");
            break;
        case Outcome::skipped:
            inside = fmt::format("      <skipped message=\"{}\"/>\n", attribute(test.text));
            break;
    }
    const std::string start = fmt::format(
        "    <testcase classname=\"tick1star\" name=\"{}\" time=\"0\"", attribute(test.name));
    return inside.empty() ? start + "/>\n" : start + ">\n" + inside + "    </testcase>\n";
}

std::vector<Case> casesOf(const StudentView& view) {
    const SubmissionResult& result = view.result();
    const Outcome verdict = outcomeOf(result.verdict);
    std::vector<Case> cases{{"Tick", verdict, verdict == Outcome::passed ? "" : verdictText(view)}};
    for (const TaskReport& task : result.tasks) {
        const bool silent = task.state == TaskState::passed && task.findings.empty();
        cases.push_back({taskName(task), outcomeOf(task), silent ? "" : taskText(view, task)});
    }
    return cases;
}

}  // namespace

std::string junitXml(const StudentView& view) {
    std::string inside;
    std::array<int, 4> counts{};
    int tests = 0;
    for (const Case& test : casesOf(view)) {
        inside += caseXml(test);
        ++counts.at(static_cast<std::size_t>(test.outcome));
        ++tests;
    }
    const auto count = [&](Outcome outcome) {
        return counts.at(static_cast<std::size_t>(outcome));
    };
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
        "  <testsuite name=\"tick1star\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
        "skipped=\"{}\" time=\"{:.3f}\">\n{}  </testsuite>\n</testsuites>\n",
        tests, count(Outcome::failed), count(Outcome::error), count(Outcome::skipped),
        view.result().timing.totalMs / 1000.0, inside);
}

}  // namespace ticker::report
