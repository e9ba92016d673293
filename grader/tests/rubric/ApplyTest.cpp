// The effect of a rubric on tasks, one condition at a time.
#include <grader/rubric/Rubric.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace ticker::rubric {
namespace {

constexpr auto kPassed = TaskState::passed;
constexpr auto kFailed = TaskState::failed;
constexpr auto kStub = TaskState::notAttempted;

/// Two options whose points differ from the default's, with a screenshot.
Rubric rubric() {
    Rubric rubric;
    rubric.maxScore = 5.0;
    rubric.options = {{.name = "one", .tasks = {"T1"}, .points = 2.0},
                      {.name = "two", .tasks = {"T2.1", "T2.2"}, .points = 4.0}};
    rubric.screenshotTask = "screenshot";
    return rubric;
}

TaskReport task(const std::string& id, TaskState state, bool needsReview = false) {
    TaskReport report;
    report.id = id;
    report.state = state;
    report.needsReview = needsReview;
    return report;
}

SubmissionResult apply(std::vector<TaskReport> tasks, const Rubric& by = rubric()) {
    SubmissionResult result;
    result.tasks = std::move(tasks);
    return applyRubric(by, result);
}

const TaskReport kPicture = task("screenshot", kPassed);

TEST(ApplyRubric, AddsThePointsOfOptionsThatPassUpToTheMost) {
    const SubmissionResult one = apply({task("T1", kPassed), kPicture});
    EXPECT_EQ(one.score, 2.0);
    EXPECT_EQ(one.maxScore, 5.0);
    EXPECT_EQ(apply({task("T2.1", kPassed), task("T2.2", kPassed), kPicture}).score, 4.0);
    EXPECT_EQ(
        apply({task("T1", kPassed), task("T2.1", kPassed), task("T2.2", kPassed), kPicture}).score,
        5.0);
    EXPECT_EQ(apply({task("T2.1", kPassed), kPicture}).score, 0.0) << "a task is missing";
}

TEST(ApplyRubric, NeedsNoPictureWhereNoneIsAskedFor) {
    Rubric without = rubric();
    without.screenshotTask.clear();
    EXPECT_EQ(apply({task("T1", kPassed)}, without).verdict, Verdict::awarded);
    EXPECT_EQ(apply({task("T1", kPassed)}).verdict, Verdict::needsReview);
    EXPECT_EQ(apply({task("T1", kPassed), task("screenshot", kFailed)}).verdict,
              Verdict::needsReview);
    EXPECT_EQ(apply({task("T1", kPassed), task("screenshot", kPassed, true)}).verdict,
              Verdict::needsReview);
}

TEST(ApplyRubric, AsksAPersonWhereTheOneOptionThatPassesIsInDoubt) {
    EXPECT_EQ(apply({task("T1", kPassed, true), kPicture}).verdict, Verdict::needsReview);
    EXPECT_EQ(apply({task("T1", kFailed, true), kPicture}).verdict, Verdict::needsReview);
    EXPECT_EQ(apply({task("T1", kFailed), task("screenshot", kFailed, true)}).verdict,
              Verdict::notAwarded)
        << "the picture does not matter";
    EXPECT_EQ(apply({task("T1", kFailed), task("screenshot", TaskState::notGraded)}).verdict,
              Verdict::notAwarded);
    EXPECT_EQ(apply({task("T1", TaskState::notGraded), kPicture}).verdict, Verdict::notGraded);
}

/// T1 is worth 2 of at most `maxScore`, T2 is worth 4.
SubmissionResult applyWithMost(double maxScore, const TaskReport& t1, const TaskReport& t2) {
    Rubric by = rubric();
    by.maxScore = maxScore;
    return apply({t1, task("T2.1", kPassed), t2, kPicture}, by);
}

TEST(ApplyRubric, AsksNobodyAboutAnOptionThatCannotAddPoints) {
    for (const TaskState state : {kPassed, kFailed, TaskState::notGraded}) {
        const SubmissionResult result =
            applyWithMost(4.0, task("T1", state, true), task("T2.2", kPassed));
        EXPECT_EQ(result.verdict, Verdict::awarded);
        EXPECT_EQ(result.score, 4.0);
    }
    EXPECT_EQ(applyWithMost(2.0, task("T1", kPassed), task("T2.2", kPassed, true)).score, 2.0);
}

TEST(ApplyRubric, AsksAPersonBeforePointsOfADoubtfulOptionAreGivenOrWithheld) {
    for (const TaskState state : {kPassed, kFailed, TaskState::blocked}) {
        const SubmissionResult result =
            applyWithMost(5.0, task("T1", state, true), task("T2.2", kPassed));
        EXPECT_EQ(result.verdict, Verdict::needsReview);
        EXPECT_EQ(result.score, 0.0) << "no score before a person has decided";
    }
    EXPECT_EQ(applyWithMost(6.0, task("T1", kPassed), task("T2.2", kPassed, true)).verdict,
              Verdict::needsReview);
}

TEST(ApplyRubric, GivesNoPointsWhileOursIsTheFaultThatOthersAreMissing) {
    EXPECT_EQ(applyWithMost(6.0, task("T1", TaskState::notGraded), task("T2.2", kPassed)).verdict,
              Verdict::notGraded);
}

TEST(ApplyRubric, AwardsWhatIsSureWhereTheOtherOptionCannotPassAnyMore) {
    for (const TaskState state : {kFailed, kStub, TaskState::blocked}) {
        const SubmissionResult result =
            applyWithMost(6.0, task("T1", state), task("T2.2", kPassed));
        EXPECT_EQ(result.verdict, Verdict::awarded);
        EXPECT_EQ(result.score, 4.0);
    }
    Rubric by = rubric();
    by.maxScore = 6.0;
    const SubmissionResult half = apply(
        {task("T1", kPassed), task("T2.1", kPassed, true), task("T2.2", kFailed), kPicture}, by);
    EXPECT_EQ(half.verdict, Verdict::awarded) << "T2.2 failed, so the doubt about T2.1 is idle";
    EXPECT_EQ(half.score, 2.0);
}

TEST(ApplyRubric, NamesTheOptionsThatWereAttempted) {
    EXPECT_EQ(apply({task("T1", kFailed)}).option, "one");
    EXPECT_EQ(apply({task("T1", kStub), task("T2.1", kStub), task("T2.2", kFailed)}).option, "two");
    EXPECT_EQ(apply({task("T1", kFailed), task("T2.2", kPassed)}).option, "both");
    EXPECT_EQ(apply({task("T1", kStub)}).option, "none");
}

TEST(ApplyRubric, TakesAFileThatWasNeverHandedInForNoAttempt) {
    TaskReport missing = task("T1", TaskState::blocked, true);
    missing.findings.resize(1);
    missing.findings[0].id = "intake.missing-file";
    EXPECT_EQ(apply({missing}).option, "none");
    EXPECT_EQ(apply({missing, task("T2.1", kFailed)}).option, "two");
    missing.findings[0].id = "build.failed";
    EXPECT_EQ(apply({missing}).option, "one");
}

TEST(ApplyRubric, AsksForNoReviewOfAPictureWithNothingToCompare) {
    TaskReport picture = task("screenshot", TaskState::blocked);
    picture.reason = "not checked: there is no code that runs to compare it with";
    EXPECT_EQ(apply({task("T1", kPassed), picture}).verdict, Verdict::awarded);
    picture.reason = "screenshot.png is a link";
    EXPECT_EQ(apply({task("T1", kPassed), picture}).verdict, Verdict::needsReview);
}

TEST(ApplyRubric, HandsOnWhatTheRubricAsksFor) {
    EXPECT_EQ(apply({task("T1", kPassed)}).options.at(1).tasks,
              (std::vector<std::string>{"T2.1", "T2.2"}));
}

TEST(ApplyRubric, ChangesTheStateOnlyByWhatFails) {
    Rubric lenient = rubric();
    lenient.severities["mild"] = Severity::warn;
    const auto stateWith = [&](TaskState state,
                               const std::vector<std::pair<std::string, Severity>>& all) {
        TaskReport report = task("T1", state);
        for (const auto& [id, severity] : all) {
            Finding finding;
            finding.id = id;
            finding.severity = severity;
            report.findings.push_back(finding);
        }
        return apply({report, kPicture}, lenient).tasks.at(0).state;
    };
    EXPECT_EQ(stateWith(kFailed, {{"mild", Severity::fail}}), kPassed);
    EXPECT_EQ(stateWith(kFailed, {{"mild", Severity::fail}, {"grave", Severity::fail}}), kFailed);
    EXPECT_EQ(stateWith(kFailed, {{"other", Severity::note}}), kFailed) << "failed by itself";
    EXPECT_EQ(stateWith(kPassed, {{"other", Severity::note}}), kPassed);
    EXPECT_EQ(stateWith(TaskState::blocked, {{"mild", Severity::fail}}), TaskState::blocked);
}

}  // namespace
}  // namespace ticker::rubric
