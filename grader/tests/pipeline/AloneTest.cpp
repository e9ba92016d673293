// A submission that is graded alone.
#include <grader/pipeline/Grade.h>
#include <grader/pipeline/Screenshot.h>
#include <grader/result/ResultJson.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace ticker::pipeline {
namespace {

// If a submission is graded alone, its runs are parallel, and the first questions about its
// screenshot are asked while the tasks are judged.
TEST(GradeSubmission, GivesTheSameResultAloneAsInAClass) {
    const std::string samples = "grader/corpus/samples/awarded/";
    for (const bool isDistributed : {true, false}) {
        const std::string sample =
            samples + (isDistributed ? "reference-distributed" : "reference-bump");
        const char* file = isDistributed ? "Renderer.cpp" : "BumpySphere.cpp";
        intake::Submission work;
        work.name = "somebody";
        work.parts[file] = tests::readFile(sample + "/" + file);
        work.parts["screenshot.png"] = tests::readFile(sample + "/screenshot.png");
        Grader grader = tests::testGraderWithScenes();
        std::vector<std::string> texts;
        for (const bool isAlone : {false, true}) {
            grader.isAlone = isAlone;
            SubmissionResult result = gradeSubmission(work, grader, 1);
            EXPECT_EQ(result.verdict, Verdict::awarded);
            result.timing = {};
            texts.push_back(resultJson(result));
        }
        EXPECT_EQ(texts[0], texts[1]) << sample;
    }
}

// A picture is rendered beside the questions only if the submission is graded alone.
TEST(GradeSubmission, GivesTheSameResultAloneWhereATaskCrashesAndAPictureOpensASocket) {
    std::string source = tests::readFile("reference_solution/exercise/Renderer.cpp");
    source.insert(source.find("const Camera camera"),
                  "if (settings().width > 100) socket(AF_INET, SOCK_STREAM, 0);\n"
                  "else if (settings().dofRayCount > 1) std::abort();\n");
    intake::Submission work;
    work.name = "somebody";
    work.parts["Renderer.cpp"] = "#include <sys/socket.h>\n#include <cstdlib>\n" + source;
    Grader grader = tests::testGraderWithScenes();
    for (const bool isAlone : {false, true}) {
        grader.isAlone = isAlone;
        const SubmissionResult result = gradeSubmission(work, grader, 1);
        EXPECT_EQ(tests::taskOf(result, "T2.1").state, TaskState::passed) << isAlone;
        EXPECT_EQ(tests::taskOf(result, "T2.2").state, TaskState::blocked) << isAlone;
    }
}

TEST(FirstQuestions, AreThoseOfTheOnlyFilesSceneAtThePicturesSize) {
    const Grader& grader = tests::testGraderWithScenes();
    intake::Submission work;
    work.parts["Renderer.cpp"] = "// not compiled here";
    EXPECT_TRUE(firstQuestions(work, "Renderer.cpp", grader, 1).empty()) << "no picture";
    work.parts["screenshot.png"] =
        tests::readFile("grader/corpus/samples/awarded/reference-distributed/screenshot.png");
    const auto questions = firstQuestions(work, "Renderer.cpp", grader, 1);
    ASSERT_EQ(questions.size(), 8U);
    const auto& first = std::get<probe::RenderQuestion>(questions.front());
    EXPECT_EQ(first.settings.width, 640);
    EXPECT_EQ(first.settings.dofRayCount, 50);
    work.parts["BumpySphere.cpp"] = "// nor this";
    EXPECT_TRUE(firstQuestions(work, "Renderer.cpp", grader, 1).empty()) << "either option";
}

}  // namespace
}  // namespace ticker::pipeline
