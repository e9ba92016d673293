#include <grader/pipeline/InputDigests.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

namespace ticker::pipeline {
namespace {

intake::Submission submissionOf(const std::string& renderer) {
    intake::Submission result;
    result.name = "ann";
    result.parts["Renderer.cpp"] = renderer;
    return result;
}

constexpr std::uint64_t kClassSeed = 7;

TEST(QuestionSeed, IsTheSameForTheSameFilesUnderTheSameSeed) {
    intake::Submission again = submissionOf("x");
    again.name = "bob";
    again.ignored = {"notes.txt"};
    EXPECT_EQ(questionSeed(submissionOf("x"), kClassSeed), questionSeed(again, kClassSeed));
}

TEST(QuestionSeed, IsAnotherForEveryOtherFile) {
    intake::Submission moved;
    moved.parts["BumpySphere.cpp"] = "x";
    intake::Submission more = submissionOf("x");
    more.parts["screenshot.png"] = "";
    const std::uint64_t first = questionSeed(submissionOf("x"), kClassSeed);
    for (const intake::Submission& other : {submissionOf("x "), submissionOf(""), moved, more})
        EXPECT_NE(questionSeed(other, kClassSeed), first);
}

TEST(QuestionSeed, IsAnotherForEveryClass) {
    EXPECT_NE(questionSeed(submissionOf("x"), kClassSeed),
              questionSeed(submissionOf("x"), kClassSeed + 1));
    EXPECT_NE(questionSeed(submissionOf("x"), kClassSeed), kClassSeed);
}

// Else a late hand-in could be made for the questions that an early one's report shows.
TEST(QuestionSeed, GivesALateHandInThatDiffersByACommentOtherQuestions) {
    const auto said = [](const std::string& comment) {
        intake::Submission work;
        work.parts["BumpySphere.cpp"] =
            "#include <raytracer/geometry/BumpySphere.h>\n#include <limits>\n" + comment +
            "namespace raytracer {\nVector3 BumpySphere::getNormalAt(const Vector3& position) "
            "const "
            "{\nreturn position * std::numeric_limits<double>::quiet_NaN();\n}\n}\n";
        const SubmissionResult result = gradeSubmission(work, tests::testGrader(), kClassSeed);
        EXPECT_EQ(result.seed, kClassSeed);
        const TaskReport& task = tests::taskOf(result, "T1");
        EXPECT_EQ(tests::findingIds(task), std::vector<std::string>{"bump.not-finite"});
        return task.reason + task.findings.at(0).message;  // it names a point and the map's size
    };
    EXPECT_EQ(said(""), said(""));
    EXPECT_NE(said(""), said("// late\n"));
}

// A stub decides what counts as not attempted, and is linked into every program.
TEST(ToolBuild, IsAnotherForEveryOtherStub) {
    namespace fs = std::filesystem;
    const tests::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms{0755});
    fs::copy(tests::testGrader().kit.folder(), folder.path() / "kit", fs::copy_options::recursive);
    const auto digest = [&] { return toolBuild(build::Kit::at(folder.path() / "kit"), {}); };
    const std::string before = digest();
    EXPECT_EQ(digest(), before);
    const std::string stub = tests::testGrader().kit.templateSource("Renderer.cpp");
    fs::remove(folder.path() / "kit/template/Renderer.cpp");
    folder.write("kit/template/Renderer.cpp", stub + "// changed\n");
    EXPECT_NE(digest(), before);
}

TEST(HowDigest, IsThatOfTheResultsOfALevelAndAnotherForEveryOtherWay) {
    Grader grader = tests::testGrader();
    const std::string level = sandbox::toString(grader.sandbox.level());
    const std::string how = inputsOf(submissionOf("x"), grader, kClassSeed).how;
    EXPECT_EQ(howDigest(grader, level, kClassSeed), how);
    EXPECT_NE(howDigest(grader, "of another machine", kClassSeed), how);
    EXPECT_NE(howDigest(grader, level, kClassSeed + 1), how);
    grader.rubricText = "{}";
    EXPECT_NE(howDigest(grader, level, kClassSeed), how);
    grader = tests::testGrader();
    grader.option = "T1";
    EXPECT_NE(howDigest(grader, level, kClassSeed), how);
}

}  // namespace
}  // namespace ticker::pipeline
