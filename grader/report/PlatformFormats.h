#ifndef TICKER_REPORT_PLATFORMFORMATS_H
#define TICKER_REPORT_PLATFORMFORMATS_H

#include <grader/report/StudentView.h>

#include <optional>
#include <string>

namespace ticker::report {

// One submission's result as a platform reads it. Each takes what a student may see, since the
// platforms show it to students. A format that knows no "could not be graded" gives nothing then:
// a missing file is a failed grader everywhere, and never a score.

/// Gradescope's results.json; docs/schema/gradescope.schema.json. One test for each task worked on,
/// without points of its own: the score is the rubric's. No test is hidden, since that would hide
/// the score as well. Empty where the result is notGraded.
[[nodiscard]] std::optional<std::string> gradescopeJson(const StudentView& view);

/// PrairieLearn's results.json; docs/schema/prairielearn.schema.json. "gradable": false where the
/// result is notGraded, which costs no attempt.
[[nodiscard]] std::string prairieLearnJson(const StudentView& view);

/// What a GitHub Classroom runner hands to the reporter, before base64;
/// docs/schema/classroom.schema.json. One test, "Tick", so that both ways in which reporters add up
/// points agree.
[[nodiscard]] std::string classroomJson(const StudentView& view);

/// The last lines that an Autolab job prints: semantic feedback, then the scores, of the problem
/// "Tick". Empty where the result is notGraded.
[[nodiscard]] std::optional<std::string> autolabLines(const StudentView& view);

/// JUnit XML as Artemis, GitLab and Jenkins read it: one suite, the case "Tick" for the verdict and
/// one for each task, always all of them, with names that never change. A task that was not
/// attempted, and a verdict that a person has to give, are skipped.
[[nodiscard]] std::string junitXml(const StudentView& view);

}  // namespace ticker::report

#endif
