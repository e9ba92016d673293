#include <grader/rubric/Audience.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::rubric {
namespace {

const std::filesystem::path kPolicy =
    std::filesystem::path{TICKER_SOURCE_DIR} / "grader/rubric/audiences.json";

Finding finding(const std::string& id, Severity severity) {
    Finding made;
    made.id = id;
    made.severity = severity;
    made.message = "seen";
    made.hint = "look there";
    made.section = "1, Theory";
    made.evidence = {{"share", 0.5}};
    return made;
}

SubmissionResult resultWith(const std::vector<Finding>& findings) {
    SubmissionResult result;
    TaskReport task;
    task.id = "T1";
    task.state = TaskState::failed;
    task.findings = findings;
    result.tasks.push_back(task);
    return result;
}

TEST(Audience, StaffSeeEverything) {
    const SubmissionResult shown =
        shownTo(readAudience(kPolicy, "staff"),
                resultWith({finding("bump.inverted", Severity::fail),
                            finding("screenshot.is-the-reference", Severity::note)}));

    ASSERT_EQ(shown.tasks[0].findings.size(), 2U);
    for (const Finding& seen : shown.tasks[0].findings) {
        EXPECT_EQ(seen.hint, "look there");
        EXPECT_EQ(seen.evidence.size(), 1U);
    }
}

TEST(Audience, StudentsSeeHintsOnFailuresAndNoNotes) {
    const SubmissionResult shown = shownTo(
        readAudience(kPolicy, "student"),
        resultWith({finding("bump.inverted", Severity::fail), finding("a.warning", Severity::warn),
                    finding("a.note", Severity::note)}));

    const std::vector<Finding>& findings = shown.tasks[0].findings;
    ASSERT_EQ(findings.size(), 2U);
    EXPECT_EQ(findings[0].hint, "look there");
    EXPECT_EQ(findings[1].message, "seen");
    EXPECT_EQ(findings[1].hint, "");
    EXPECT_TRUE(findings[1].evidence.empty());
}

TEST(Audience, StudentsAreNotToldWhatAPersonHasToAskThem) {
    const SubmissionResult shown =
        shownTo(readAudience(kPolicy, "student"),
                resultWith({finding("screenshot.is-the-reference", Severity::fail)}));

    EXPECT_TRUE(shown.tasks[0].findings.empty());
    EXPECT_EQ(shown.tasks[0].state, TaskState::failed);
}

TEST(Audience, APolicyThatDoesNotFitIsRefusedWithItsPlace) {
    struct Wrong {
        std::string text;
        std::string expected;
    };
    const std::string usual =
        R"("verdict": true, "fail": "hint", "warn": "hint", "note": "hint", )";
    const tests::TemporaryFolder folder;
    for (const Wrong& wrong :
         {Wrong{"no", "not JSON"}, Wrong{"{}", "a member \"student\""},
          Wrong{R"({"student": {)" + usual + R"("findings": []}})", "/student/findings"},
          Wrong{R"({"student": {)" + usual + R"("findings": {"a": "loud"}}})",
                "/student/findings/a"},
          Wrong{R"({"student": {)" + usual + R"("findings": {}, "more": 1}})", "/student/more"}}) {
        folder.write("audiences.json", wrong.text);
        try {
            static_cast<void>(readAudience(folder.path() / "audiences.json", "student"));
            FAIL() << wrong.text;
        } catch (const raytracer::InputError& error) {
            EXPECT_NE(std::string{error.what()}.find(wrong.expected), std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace ticker::rubric
