#include <grader/report/platforms/PlatformFormats.h>

#include <grader/report/Escape.h>

#include <fmt/core.h>

#include <array>
#include <string_view>

namespace ticker::report {
namespace {

enum class Outcome { passed, failed, skipped };

struct Case {
    std::string className;  ///< "tick1star.exercise/BumpySphere", or "tick1star" without a file
    std::string name;
    Outcome outcome = Outcome::passed;
    std::string text;  ///< empty without a text
};

Outcome outcomeOf(const TaskReport& task) {
    if (!isCertain(task) || task.state == TaskState::notAttempted) return Outcome::skipped;
    return task.state == TaskState::passed ? Outcome::passed : Outcome::failed;
}

Outcome outcomeOf(const SubmissionResult& result) {
    if (!hasScore(result)) return Outcome::skipped;
    return result.verdict == Verdict::awarded ? Outcome::passed : Outcome::failed;
}

/// The reason both as attribute, which Artemis and Jenkins show, and as text, which GitLab shows.
std::string withReason(std::string_view element, const std::string& text) {
    return fmt::format("      <{0} message=\"{1}\">{2}</{0}>\n", element,
                       escapeHtml(text.substr(0, text.find('\n'))), escapeHtml(text));
}

/// Package and class, as Java has them. The GitHub action mikepenz/action-junit-report annotates a
/// file whose path ends with the last part of this name and any suffix.
std::string classNameOf(const Exercise& exercise, std::string_view task) {
    const std::string_view file = exercise.fileOf(task);
    if (file.empty()) return exercise.name;
    return fmt::format("{}.exercise/{}", exercise.name, file.substr(0, file.find('.')));
}

std::string caseXml(const Case& test) {
    std::string inside;
    if (test.outcome == Outcome::failed)
        inside = withReason("failure", test.text);
    else if (test.outcome == Outcome::skipped)
        inside = withReason("skipped", test.text);
    else if (!test.text.empty())
        inside = fmt::format("      <system-out>{}</system-out>\n", escapeHtml(test.text));
    const std::string start = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"",
                                          escapeHtml(test.className), escapeHtml(test.name));
    return inside.empty() ? start + "/>\n" : start + ">\n" + inside + "    </testcase>\n";
}

std::vector<Case> casesOf(const StudentView& view) {
    const SubmissionResult& result = view.result();
    const Outcome verdict = outcomeOf(result);
    std::vector<Case> cases{{view.exercise().name, "Tick", verdict,
                             verdict == Outcome::passed ? "" : verdictText(view)}};
    for (const TaskReport& task : result.tasks) {
        const bool silent = task.state == TaskState::passed && task.findings.empty();
        cases.push_back({classNameOf(view.exercise(), task.id), taskName(task), outcomeOf(task),
                         silent ? "" : taskText(view, task)});
    }
    return cases;
}

}  // namespace

std::optional<std::string> junitXml(const StudentView& view) {
    if (view.result().verdict == Verdict::notGraded) return std::nullopt;
    std::string inside;
    std::array<int, 3> counts{};
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
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" "
        "skipped=\"{}\" time=\"{:.3f}\">\n{}  </testsuite>\n</testsuites>\n",
        view.exercise().name, tests, count(Outcome::failed), count(Outcome::skipped),
        view.result().timing.totalMs / 1000.0, inside);
}

}  // namespace ticker::report
