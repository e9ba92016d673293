#ifndef TICKER_REPORT_PLATFORMFORMATS_H
#define TICKER_REPORT_PLATFORMFORMATS_H

#include <grader/report/student/StudentView.h>

#include <optional>
#include <string>

namespace ticker::report {

// One submission's result in the format of a platform. Each is made from a StudentView, because
// platforms show it to students. If there is no score, because a ticker decides or the grader
// failed, each format uses its platform's value for that: without a file some platforms report a
// failed grader, others a zero. Their rules are in grader/tests/report/ClientRules.h.

/// Gradescope's results.json; docs/schema/gradescope.schema.json. One test for each attempted task,
/// without points: the score is the rubric's. Tests are visible, because a hidden one hides the
/// score, except when there is no score yet. Empty if the result is notGraded: a missing file
/// reports a failed grader.
[[nodiscard]] std::optional<std::string> gradescopeJson(const StudentView& view);

/// PrairieLearn's results.json; docs/schema/prairielearn.schema.json. The test "Tick" has all
/// points, the tasks have none. Without a score "gradable" is false, which uses up no attempt.
[[nodiscard]] std::string prairieLearnJson(const StudentView& view);

/// The data that a GitHub Classroom runner passes to the reporter, before base64;
/// docs/schema/classroom.schema.json. One test, "Tick", so that both ways in which reporters add up
/// points agree; no points without a score.
[[nodiscard]] std::string classroomJson(const StudentView& view);

/// Markdown for the summary of a workflow's step, where students read the reasons: the text as one
/// block of escaped HTML.
[[nodiscard]] std::string classroomSummary(const StudentView& view);

/// The last lines that an Autolab job prints: the text, a line of semantic feedback, and a line
/// with the score of the problem "Tick", which is null without a score. Without that line Autolab
/// stores a 0.
[[nodiscard]] std::string autolabLines(const StudentView& view);

/// JUnit XML for Artemis, GitLab and Jenkins: one suite, with the case "Tick" for the verdict and a
/// case for each task. All cases are always present, with constant names. A task that is not
/// attempted, not checked or in review is skipped. Empty if the result is notGraded: Artemis reads
/// an error as a failure.
[[nodiscard]] std::optional<std::string> junitXml(const StudentView& view);

/// Workflow commands that GitHub shows as annotations at the student's lines, one for each error of
/// the compiler and each finding. Findings have a task's id in braces for the line, "line={ID}":
/// the step that prints them knows where the task begins. Empty where the result is notGraded.
[[nodiscard]] std::optional<std::string> gitHubAnnotations(const StudentView& view);

}  // namespace ticker::report

#endif
