#ifndef TICKER_REPORT_PLATFORMFORMATS_H
#define TICKER_REPORT_PLATFORMFORMATS_H

#include <grader/report/StudentView.h>

#include <optional>
#include <string>

namespace ticker::report {

// One submission's result as a platform reads it. Each takes what a student may see, since the
// platforms show it to students. Where there is no score, because a person decides or because it
// was not graded for our reasons, each uses what its platform has for that; no file at all is a
// failed grader to some, and a zero to others. Their rules are in
// grader/tests/report/ClientRules.h.

/// Gradescope's results.json; docs/schema/gradescope.schema.json. One test for each task worked on,
/// without points of its own: the score is the rubric's. No test is hidden, since that would hide
/// the score as well, but where there is none yet. Empty where the result is notGraded: without the
/// file the grader has failed.
[[nodiscard]] std::optional<std::string> gradescopeJson(const StudentView& view);

/// PrairieLearn's results.json; docs/schema/prairielearn.schema.json. The test "Tick" has all
/// points, those of the tasks none. "gradable": false where there is no score, which costs no
/// attempt.
[[nodiscard]] std::string prairieLearnJson(const StudentView& view);

/// What a GitHub Classroom runner hands to the reporter, before base64;
/// docs/schema/classroom.schema.json. One test, "Tick", so that both ways in which reporters add up
/// points agree; no points where there is no score.
[[nodiscard]] std::string classroomJson(const StudentView& view);

/// Markdown for the summary of a workflow's step, which is where students read why: the text as one
/// block of escaped HTML.
[[nodiscard]] std::string classroomSummary(const StudentView& view);

/// The last lines that an Autolab job prints: the text, a line of semantic feedback, and a line
/// with the score of the problem "Tick"; null where there is none. Without that line Autolab stores
/// a 0.
[[nodiscard]] std::string autolabLines(const StudentView& view);

/// JUnit XML as Artemis, GitLab and Jenkins read it: one suite, the case "Tick" for the verdict and
/// one for each task, always all of them, with names that never change. What was not attempted, not
/// checked or is a person's to decide is skipped. Empty where the result is notGraded: Artemis
/// takes an error for a failure.
[[nodiscard]] std::optional<std::string> junitXml(const StudentView& view);

}  // namespace ticker::report

#endif
