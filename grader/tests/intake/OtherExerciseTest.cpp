#include <grader/intake/Intake.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ticker::intake {
namespace {

/// An exercise with a file of its own and one that shares its name with the default one's.
const std::vector<Exercise>& fog() {
    static const std::vector<Exercise> kFog = [] {
        Exercise exercise;
        exercise.name = "fog";
        exercise.title = "Fog";
        exercise.tasks = {{"F1", "Fog", "Fog.cpp", "fog", {}},
                          {"F2", "Mist", "Renderer.cpp", "mist", {}}};
        exercise.frameworkFiles = {"framework/src/Fog.cpp"};
        return std::vector{exercise};
    }();
    return kFog;
}

std::string marked(const std::string& task) {
    return "// TASK " + task + " begin\nint x;\n// TASK " + task + " end\n";
}

Submission readBeside(const tests::TemporaryFolder& folder) {
    return readSubmission({"somebody", folder.path()}, {.others = fog()});
}

TEST(OtherExercise, IsToldByAFileThatOnlyItHas) {
    const tests::TemporaryFolder folder;
    folder.write("Fog.cpp", "int x;");
    folder.write("Renderer.cpp", "int y;");
    folder.write("screenshot.png", "picture");
    const Submission submission = readBeside(folder);
    EXPECT_EQ(submission.otherExercise, "fog");
    ASSERT_EQ(submission.findings.size(), 1U);
    EXPECT_EQ(submission.findings[0].finding.id, "intake.missing-file");
    EXPECT_EQ(submission.findings[0].finding.message, "These are files of another exercise, Fog.");
    const std::string& hint = submission.findings[0].finding.hint;
    EXPECT_TRUE(hint.starts_with("Hand in BumpySphere.cpp")) << hint;
    EXPECT_TRUE(hint.ends_with(" or " + defaultExercise().tasks.back().file + " of Tick 1*."))
        << hint;
    EXPECT_NE(submission.refusalOf("Renderer.cpp"), nullptr);
}

TEST(OtherExercise, IsToldByTheMarksWhereBothHaveAFileOfTheName) {
    const tests::TemporaryFolder folder;
    folder.write("Renderer.cpp", marked("F2"));
    EXPECT_EQ(readBeside(folder).otherExercise, "fog");
}

TEST(OtherExercise, IsNoneWhereOneFileIsOfThis) {
    for (const std::string& mine : {marked("T2.1"), marked("F2") + marked("T2.2")}) {
        const tests::TemporaryFolder folder;
        folder.write("Renderer.cpp", mine);
        folder.write("Fog.cpp", marked("F1"));
        EXPECT_EQ(readBeside(folder).otherExercise, "");
    }
}

TEST(OtherExercise, IsNoneForASharedNameWithoutMarksOrForTheFrameworksOwnFiles) {
    const tests::TemporaryFolder folder;
    folder.write("exercise/Renderer.cpp", "int x;");
    folder.write("framework/src/Fog.cpp", "int y;");
    const Submission submission = readBeside(folder);
    EXPECT_EQ(submission.otherExercise, "");
    EXPECT_TRUE(submission.findings.empty());
}

}  // namespace
}  // namespace ticker::intake
