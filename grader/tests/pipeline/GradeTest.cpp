#include <grader/picture/DecodePicture.h>
#include <grader/pipeline/Grade.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace ticker::pipeline {
namespace {

using tests::findingIds;
using tests::taskOf;

constexpr std::uint64_t kSeed = 1;

std::string stub(const char* name) {
    return tests::readFile("student_template/exercise/" + std::string{name});
}

intake::Submission submission(const std::optional<std::string>& bumpySphere,
                              const std::optional<std::string>& renderer = {}) {
    intake::Submission result;
    result.name = "somebody";
    result.parts["BumpySphere.cpp"] = bumpySphere;
    result.parts["Renderer.cpp"] = renderer;
    return result;
}

SubmissionResult grade(const intake::Submission& work) {
    return gradeSubmission(work, tests::testGrader(), kSeed);
}

using Ids = std::vector<std::string>;

TEST(GradeSubmission, ListsTheFourTasksInOrderWithTheirCircumstances) {
    const SubmissionResult result = grade(submission({}));
    ASSERT_EQ(result.tasks.size(), 4U);
    EXPECT_EQ(result.tasks[0].id, "T1");
    EXPECT_EQ(result.tasks[1].id, "T2.1");
    EXPECT_EQ(result.tasks[2].id, "T2.2");
    EXPECT_EQ(result.tasks[3].id, "screenshot");
    EXPECT_EQ(result.submission, "somebody");
    EXPECT_EQ(result.seed, kSeed);
    EXPECT_EQ(result.toolVersion, "test");
    EXPECT_EQ(result.sandboxLevel, sandbox::toString(tests::testGrader().sandbox.level()));
}

TEST(GradeSubmission, CompilesNothingWhereEveryStubStillStands) {
    const SubmissionResult result =
        grade(submission(stub("BumpySphere.cpp"), stub("Renderer.cpp")));
    for (const char* task : {"T1", "T2.1", "T2.2", "screenshot"})
        EXPECT_EQ(taskOf(result, task).state, TaskState::notAttempted) << task;
    EXPECT_EQ(result.verdict, Verdict::notAwarded);
    EXPECT_EQ(result.timing.compileMs, 0.0);
    EXPECT_EQ(result.option, "none");
}

// A thread for each row: 120 of them in the report's picture.
TEST(GradeSubmission, RendersThePicturesOfCodeWithAThreadForEachRow) {
    const SubmissionResult result = gradeSubmission(
        submission({}, tests::readFile(
                           "grader/corpus/unseen/T2/right/async-sobol-antithetic/Renderer.cpp")),
        tests::testGraderWithScenes(), kSeed);
    EXPECT_EQ(taskOf(result, "T2.2").state, TaskState::passed);
    ASSERT_EQ(result.renders.size(), 1U);
    EXPECT_EQ(result.renders[0].scene, "distributed");
    EXPECT_LT(result.renders[0].rmse, 5.0);
}

TEST(GradeSubmission, LetsABrokenFileBlockItsOwnTaskOnly) {
    const SubmissionResult result = grade(submission(
        "this is no C++\n", tests::readFile("reference_solution/exercise/Renderer.cpp")));
    EXPECT_EQ(taskOf(result, "T1").state, TaskState::blocked);
    EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"build.failed"});
    EXPECT_EQ(taskOf(result, "T2.1").state, TaskState::passed);
    EXPECT_EQ(taskOf(result, "T2.2").state, TaskState::passed);
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].file, "BumpySphere.cpp");
    EXPECT_NE(result.diagnostics[0].text.find("BumpySphere.cpp:1:"), std::string::npos);
    EXPECT_EQ(result.verdict, Verdict::needsReview) << "the picture is missing";
}

// A header of the student's own, or a path to the kit's that exists on the student's disk only.
TEST(GradeSubmission, SaysThatAFileIsCompiledAloneWhereAHeaderIsMissing) {
    for (const char* header :
         {"maths.h", "../framework/include/raytracer/geometry/BumpySphere.h"}) {
        const SubmissionResult result =
            grade(submission(std::string{"#include \""} + header + "\"\n", {}));
        ASSERT_EQ(findingIds(taskOf(result, "T1")), Ids{"build.failed"});
        const std::string& hint = taskOf(result, "T1").findings.front().hint;
        EXPECT_NE(hint.find("compiled alone"), std::string::npos) << hint;
        EXPECT_NE(hint.find("<raytracer/"), std::string::npos) << hint;
    }
}

TEST(GradeSubmission, BlocksBothTasksOfABrokenRendererButNotTheStubInIt) {
    std::string source = stub("Renderer.cpp");
    const std::string line = "const Ray ray = camera.castRay(x, y);";
    source.replace(source.find(line), line.size(), "nonsense");
    const SubmissionResult result = grade(submission({}, source));
    EXPECT_EQ(taskOf(result, "T2.1").state, TaskState::notAttempted);
    EXPECT_EQ(taskOf(result, "T2.2").state, TaskState::blocked);
    EXPECT_EQ(findingIds(taskOf(result, "T2.2")), Ids{"build.failed"});
}

// Students print values while they debug, and forget to remove the line.
TEST(GradeSubmission, TakesARightAnswerThatPrintsALineForEachCall) {
    std::string source = tests::readFile("reference_solution/exercise/BumpySphere.cpp");
    const std::string mark = "// TASK T1 begin\n";
    ASSERT_NE(source.find(mark), std::string::npos);
    source.insert(source.find(mark) + mark.size(),
                  "std::cout << \"normal at \" << position.x << ' ' << position.y << std::endl;\n");
    EXPECT_EQ(taskOf(grade(submission("#include <iostream>\n" + source)), "T1").state,
              TaskState::passed);
}

// The memory may run out in our own code, between two answers.
TEST(GradeSubmission, NamesMemoryThatLeaksAwayFromAnswerToAnswer) {
    std::string source = tests::readFile("reference_solution/exercise/BumpySphere.cpp");
    const std::string mark = "// TASK T1 begin\n";
    ASSERT_NE(source.find(mark), std::string::npos);
    source.insert(source.find(mark) + mark.size(),
                  "static char* volatile kept = nullptr; kept = new char[1 << 20];\n");
    Grader grader = tests::testGrader();
    grader.policy.run.addressSpaceBytes = 500'000'000;
    const SubmissionResult result = gradeSubmission(submission(source), grader, kSeed);
    EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"run.memory"});
}

// Sleeping uses no CPU time.
TEST(GradeSubmission, SharesTheTimeOfASubmissionAmongItsFiles) {
    const std::string bump =
        "#include <raytracer/geometry/BumpySphere.h>\n#include <chrono>\n#include <thread>\n"
        "namespace raytracer {\nVector3 BumpySphere::getNormalAt(const Vector3&) const {\n"
        "std::this_thread::sleep_for(std::chrono::hours(1)); return {};\n}\n}\n";
    Grader grader = tests::testGrader();
    grader.policy.submission = {600.0, 4.0};
    const SubmissionResult result = gradeSubmission(
        submission(bump, tests::readFile("reference_solution/exercise/Renderer.cpp")), grader,
        kSeed);
    for (const char* id : {"T1", "T2.1", "T2.2"}) {
        const TaskReport& task = taskOf(result, id);
        ASSERT_EQ(findingIds(task), Ids{"run.timed-out"}) << id;
        EXPECT_NE((task.reason + task.findings.at(0).message).find("together may take 4 s"),
                  std::string::npos)
            << id << task.reason;
    }
}

TEST(GradeSubmission, CallsAReplacedFrameworkForbidden) {
    const SubmissionResult result =
        grade(submission(tests::readFile("reference_solution/exercise/BumpySphere.cpp") +
                         "int main() { return 0; }\n"));
    EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"build.forbidden"});
    EXPECT_EQ(result.verdict, Verdict::notAwarded);
}

TEST(GradeSubmission, PassesOnWhatIntakeRefused) {
    intake::Submission work = submission({}, stub("Renderer.cpp"));
    Finding refused;
    refused.id = "intake.ambiguous";
    refused.message = "two files";
    work.findings.push_back({"BumpySphere.cpp", refused});
    const SubmissionResult result = grade(work);
    EXPECT_EQ(taskOf(result, "T1").state, TaskState::blocked);
    EXPECT_EQ(taskOf(result, "T1").reason, "two files");
    EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"intake.ambiguous"});
    EXPECT_EQ(taskOf(result, "T2.1").state, TaskState::notAttempted);
    EXPECT_EQ(result.verdict, Verdict::needsReview);
}

TEST(GradeSubmission, RefusesAWholeArchive) {
    intake::Submission work = submission({});
    Finding refused;
    refused.id = "intake.unsafe-archive";
    work.findings.push_back({std::nullopt, refused});
    const SubmissionResult result = grade(work);
    for (const TaskReport& task : result.tasks) {
        EXPECT_EQ(task.state, TaskState::blocked) << task.id;
        EXPECT_EQ(findingIds(task), Ids{"intake.unsafe-archive"}) << task.id;
    }
    EXPECT_EQ(result.verdict, Verdict::notAwarded);
}

TEST(GradeSubmission, JudgesTheChosenOptionOnly) {
    Grader grader = tests::testGrader();
    grader.option = "T2";
    const SubmissionResult result =
        gradeSubmission(submission("this is no C++\n", stub("Renderer.cpp")), grader, kSeed);
    EXPECT_EQ(taskOf(result, "T1").state, TaskState::notAttempted);
}

TEST(GradeSubmission, ListsWhatWasIgnored) {
    intake::Submission work = submission({});
    work.ignored = {"notes.txt", "Vector3.h"};
    const SubmissionResult result = grade(work);
    EXPECT_EQ(result.notices, Ids{"Ignored: notes.txt, Vector3.h"});
}

TEST(GradeSubmission, GivesEqualFindingsForEqualSeeds) {
    const intake::Submission work =
        submission(tests::readFile("reference_solution/exercise/BumpySphere.cpp"));
    const SubmissionResult first = grade(work);
    const SubmissionResult second = grade(work);
    EXPECT_EQ(first.verdict, second.verdict);
    EXPECT_EQ(findingIds(first.tasks[0]), findingIds(second.tasks[0]));
}

TEST(GradeSubmission, ShowsWhatTheCodeRendersBesideWhatWasExpected) {
    intake::Submission work =
        submission(tests::readFile("reference_solution/exercise/BumpySphere.cpp"),
                   tests::readFile("reference_solution/exercise/Renderer.cpp"));
    work.parts["screenshot.png"] =
        tests::readFile("grader/corpus/samples/awarded/reference-bump/screenshot.png");

    const SubmissionResult result = gradeSubmission(work, tests::testGraderWithScenes(), kSeed);

    EXPECT_EQ(result.verdict, Verdict::awarded);
    ASSERT_EQ(result.renders.size(), 3U);
    for (const RenderScore& render : result.renders) {
        // Measured: FLIP 0.024 and SSIM 0.939 if each pixel is the mean of 12 paths (SpecScenesTest
        // has the handout's 50); 0.0002 and 0.99996 without random rays.
        const bool isNoisy = render.scene == "distributed";
        EXPECT_LT(render.flip, isNoisy ? 0.04 : 0.001) << render.scene;
        EXPECT_GT(render.ssim, isNoisy ? 0.9 : 0.999) << render.scene;
        EXPECT_EQ(render.zMap.empty(), !isNoisy) << render.scene;
    }
    std::vector<std::string> files;
    for (const ResultPicture& picture : result.pictures) {
        files.push_back(picture.file);
        EXPECT_TRUE(picture::claimedSize(picture.png)) << picture.file;
    }
    EXPECT_EQ(files.size(), 13U);
    EXPECT_EQ(std::count(files.begin(), files.end(), "images/screenshot.png"), 1);
    EXPECT_EQ(std::count(files.begin(), files.end(), "images/T1-2.png"), 1) << "the relief";
}

TEST(NotGraded, IsNeverAScore) {
    const SubmissionResult result =
        notGradedResult("somebody", "the disk is full", tests::testGrader(), kSeed);
    EXPECT_EQ(result.verdict, Verdict::notGraded);
    for (const TaskReport& task : result.tasks)
        EXPECT_EQ(task.state, TaskState::notGraded) << task.id;
    EXPECT_EQ(result.tasks[0].reason, "the disk is full");
}

}  // namespace
}  // namespace ticker::pipeline
