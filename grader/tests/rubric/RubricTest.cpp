#include <grader/rubric/Rubric.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

namespace ticker::rubric {
namespace {

const std::filesystem::path kDefault{TICKER_SOURCE_DIR "/grader/rubric/rubric.json"};

TaskReport taskOf(const std::string& id, TaskState state, std::vector<Finding> findings = {}) {
    TaskReport report;
    report.id = id;
    report.state = state;
    report.findings = std::move(findings);
    return report;
}

Finding finding(const std::string& id, Severity severity) {
    Finding made;
    made.id = id;
    made.severity = severity;
    return made;
}

SubmissionResult submission(TaskState t1, TaskState t21, TaskState t22,
                            TaskState screenshot = TaskState::passed) {
    SubmissionResult result;
    result.tasks = {taskOf("T1", t1), taskOf("T2.1", t21), taskOf("T2.2", t22),
                    taskOf("screenshot", screenshot)};
    return result;
}

constexpr auto kPassedState = TaskState::passed;
constexpr auto kFailedState = TaskState::failed;
constexpr auto kStubState = TaskState::notAttempted;

TEST(DefaultRubric, AwardsEitherOptionAndNoMoreThanOneForBoth) {
    const Rubric rubric = readRubric(kDefault);
    const auto t1 = applyRubric(rubric, submission(kPassedState, kStubState, kStubState));
    EXPECT_EQ(t1.verdict, Verdict::awarded);
    EXPECT_EQ(t1.option, "T1");
    EXPECT_EQ(t1.score, 1.0);
    const auto t2 = applyRubric(rubric, submission(kStubState, kPassedState, kPassedState));
    EXPECT_EQ(t2.verdict, Verdict::awarded);
    EXPECT_EQ(t2.option, "T2");
    const auto both = applyRubric(rubric, submission(kPassedState, kPassedState, kPassedState));
    EXPECT_EQ(both.option, "both");
    EXPECT_EQ(both.score, 1.0);
}

TEST(DefaultRubric, DoesNotAwardHalfAnOptionOrAnUntouchedTemplate) {
    const Rubric rubric = readRubric(kDefault);
    EXPECT_EQ(applyRubric(rubric, submission(kFailedState, kPassedState, kFailedState)).verdict,
              Verdict::notAwarded);
    EXPECT_EQ(applyRubric(rubric, submission(kStubState, kPassedState, kStubState)).verdict,
              Verdict::notAwarded);
    const auto untouched = applyRubric(rubric, submission(kStubState, kStubState, kStubState));
    EXPECT_EQ(untouched.verdict, Verdict::notAwarded);
    EXPECT_EQ(untouched.option, "none");
    EXPECT_EQ(untouched.score, 0.0);
}

TEST(DefaultRubric, AwardsOneGoodOptionThoughTheOtherFailed) {
    EXPECT_EQ(applyRubric(readRubric(kDefault),
                          submission(kPassedState, kFailedState, TaskState::blocked))
                  .verdict,
              Verdict::awarded);
}

TEST(DefaultRubric, SendsAMissingScreenshotToAPersonOnlyWhereItMatters) {
    const Rubric rubric = readRubric(kDefault);
    EXPECT_EQ(
        applyRubric(rubric, submission(kPassedState, kStubState, kStubState, kStubState)).verdict,
        Verdict::needsReview);
    EXPECT_EQ(
        applyRubric(rubric, submission(kFailedState, kStubState, kStubState, kStubState)).verdict,
        Verdict::notAwarded);
}

TEST(DefaultRubric, NeverTurnsOurFaultIntoAScore) {
    const Rubric rubric = readRubric(kDefault);
    const auto ours = applyRubric(rubric, submission(TaskState::notGraded, kStubState, kStubState));
    EXPECT_EQ(ours.verdict, Verdict::notGraded);
    EXPECT_EQ(ours.score, 0.0);
    EXPECT_EQ(
        applyRubric(rubric, submission(TaskState::notGraded, kPassedState, kPassedState)).verdict,
        Verdict::awarded);
}

TEST(DefaultRubric, SendsADoubtfulTaskToAPerson) {
    SubmissionResult doubtful = submission(kStubState, kPassedState, kPassedState);
    doubtful.tasks[2].needsReview = true;
    EXPECT_EQ(applyRubric(readRubric(kDefault), doubtful).verdict, Verdict::needsReview);
}

TEST(RubricSeverities, ChangeWhatAFindingDoesToItsTask) {
    Rubric rubric = readRubric(kDefault);
    rubric.severities["bump.inverted-u"] = Severity::warn;
    rubric.severities["bump.mirrored"] = Severity::fail;
    SubmissionResult lenient = submission(kFailedState, kStubState, kStubState);
    lenient.tasks[0].findings = {finding("bump.inverted-u", Severity::fail)};
    EXPECT_EQ(applyRubric(rubric, lenient).verdict, Verdict::awarded);
    SubmissionResult strict = submission(kPassedState, kStubState, kStubState);
    strict.tasks[0].findings = {finding("bump.mirrored", Severity::note)};
    EXPECT_EQ(applyRubric(rubric, strict).tasks[0].state, TaskState::failed);
}

Rubric readText(const std::string& text) {
    const tests::TemporaryFolder folder;
    folder.write("rubric.json", text);
    return readRubric(folder.path() / "rubric.json");
}

std::string withSeverities(const std::string& severities) {
    return R"({"maxScore": 1, "options": [{"name": "a", "tasks": ["T1"], "points": 1}],
        "screenshotTask": "", "severities": )" +
           severities + "}";
}

TEST(ReadRubric, TakesSeveritiesThatDifferFromTheDecisions) {
    const Rubric rubric =
        readText(withSeverities(R"({"bump.mirrored": "fail", "bump.inverted-u": "note"})"));

    const std::map<std::string, Severity> expected{{"bump.mirrored", Severity::fail},
                                                   {"bump.inverted-u", Severity::note}};
    EXPECT_EQ(rubric.severities, expected);
}

std::string messageFor(const std::string& text) {
    try {
        static_cast<void>(readText(text));
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "no error";
}

void expectMessage(const std::string& text, const std::string& part) {
    const std::string message = messageFor(text);
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(ReadRubric, RefusesAFindingThatDoesNotExistAndSaysWhichWasMeant) {
    expectMessage(withSeverities("{\n\"bump.inverted-w\": \"warn\"}"),
                  "rubric.json:3: /severities/bump.inverted-w: expected a finding of "
                  "docs/findings.md; did you mean \"bump.inverted-");
    expectMessage(withSeverities(R"({"shadow.harsh": "warn"})"), "did you mean \"shadow.hard\"?");
    expectMessage(withSeverities(R"({"dof.aperturesize": "note"})"),
                  "did you mean \"dof.aperture-size\"?");
    expectMessage(withSeverities(R"({"everything": "fail"})"),
                  "/severities/everything: expected a finding of docs/findings.md");
    expectMessage(R"({"maxScore": 1, "options": [{"name": "a", "tasks": ["T1"], "points": 1}],
        "screenshotTask": "screenshots", "severities": {}})",
                  "rubric.json:2: /screenshotTask: expected \"screenshot\"");
}

TEST(ReadRubric, RefusesNamesOfOptionsThatSayNothing) {
    for (const char* name : {"", "both", "none"})
        expectMessage(R"({"maxScore": 1, "options": [{"name": ")" + std::string{name} +
                          R"(", "tasks": ["T1"], "points": 1}],
        "screenshotTask": "", "severities": {}})",
                      "rubric.json:1: /options/0/name: expected a name of its own");
    expectMessage(R"({"maxScore": 1, "options": [
        {"name": "a", "tasks": ["T1"], "points": 1},
        {"name": "a", "tasks": ["T2.1"], "points": 1}], "screenshotTask": "", "severities": {}})",
                  "rubric.json:3: /options/1/name");
}

TEST(ReadRubric, NamesTheLineOfWhatDoesNotFit) {
    expectMessage(
        "{\n \"maxScore\": 1,\n \"options\": [\n  {\"name\": \"a\",\n   \"tasks\": "
        "[\"T1\",\n    \"T7\"], \"points\": 1}]}",
        "rubric.json:6: /options/0/tasks/1");
    expectMessage("{\n\n \"maxScore\": -1\n}", "rubric.json:3: /maxScore: expected a number");
    expectMessage("{\n \"maxscore\": 1}", "rubric.json:2: /maxscore");
    expectMessage("{\n \"maxScore\": 1,\n}", "rubric.json:3: not JSON");
    expectMessage("\n[]", "rubric.json:2: the whole file: expected an object");
    // A bracket in a string, an escaped quote, and a member that comes twice: the last one counts.
    expectMessage("{\"severities\": {\"a]}\\\"\": 1},\n \"maxScore\": 1,\n \"maxScore\": \"1\"}",
                  "rubric.json:3: /maxScore");
}

TEST(ReadRubric, SaysWhichMemberDoesNotFit) {
    EXPECT_NE(messageFor("{").find("not JSON"), std::string::npos);
    EXPECT_NE(messageFor("[]").find("an object"), std::string::npos);
    EXPECT_NE(messageFor(R"({"maxScore": 1})").find("a member \"options\""), std::string::npos);
    EXPECT_NE(messageFor(R"({"maxScore": 1, "options": [{"name": "a", "tasks": ["T9"],
        "points": 1}], "screenshotTask": "", "severities": {}})")
                  .find("/options/0/tasks/0: expected \"T1\""),
              std::string::npos);
    EXPECT_NE(messageFor(withSeverities(R"({"bump.flat": "harsh"})"))
                  .find("/severities/bump.flat: expected \"fail\""),
              std::string::npos);
    EXPECT_NE(messageFor(R"({"maxscore": 1})").find("/maxscore"), std::string::npos);
}

}  // namespace
}  // namespace ticker::rubric
