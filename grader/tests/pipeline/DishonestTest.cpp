// Code that answers questions and renders something else.
#include <grader/pipeline/Grade.h>
#include <grader/tasks/lens/checks/PictureDoubt.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <optional>

namespace ticker::pipeline {
namespace {

using tests::findingIds;
using tests::taskOf;
using Ids = std::vector<std::string>;

/// The reference with code at the beginning of a function.
std::string referenceWith(const char* file, const std::string& function, const std::string& text) {
    std::string source = tests::readFile("reference_solution/exercise/" + std::string{file});
    const std::size_t begin = source.find('{', source.find(function)) + 1;
    return source.insert(begin, text);
}

SubmissionResult gradeRenderer(const std::string& atTheBeginningOfRender) {
    intake::Submission work;
    work.name = "somebody";
    work.parts["Renderer.cpp"] =
        referenceWith("Renderer.cpp", "Renderer::render", atTheBeginningOfRender);
    return gradeSubmission(work, tests::testGraderWithScenes(), 1);
}

std::vector<TaskReport> reports(TaskState shadows, TaskState lens) {
    std::vector<TaskReport> tasks(2);
    tasks[0].state = shadows;
    tasks[1].state = lens;
    return tasks;
}

TEST(Dishonest, PicturesThatAnswersDoNotExplainAreLeftToAPerson) {
    const SubmissionResult result =
        gradeRenderer("if (settings().width > 100) return Image{settings()};");
    EXPECT_EQ(taskOf(result, "T2.2").state, TaskState::passed);
    EXPECT_EQ(findingIds(taskOf(result, "T2.2")), Ids{"dof.picture-differs"});
    EXPECT_EQ(result.verdict, Verdict::needsReview);
}

TEST(Dishonest, ACrashInThePictureAsksForReview) {
    const SubmissionResult result = gradeRenderer("if (settings().width > 100) std::abort();");
    EXPECT_EQ(findingIds(taskOf(result, "T2.2")), Ids{"dof.picture-differs"});
    EXPECT_EQ(result.verdict, Verdict::needsReview);
}

// Code that returns a black picture where no observer is set.
TEST(Dishonest, CodeCannotTellWhetherItIsObserved) {
    const SubmissionResult result =
        gradeRenderer("if (settings().observer == nullptr) return Image{settings()};");
    EXPECT_EQ(findingIds(taskOf(result, "T2.2")), Ids{});
    ASSERT_EQ(result.renders.size(), 1U);
    EXPECT_LT(result.renders[0].flip, 0.04);
}

TEST(Dishonest, BumpsOnLargeSpheresAloneFail) {
    intake::Submission work;
    work.name = "somebody";
    work.parts["BumpySphere.cpp"] =
        referenceWith("BumpySphere.cpp", "BumpySphere::getNormalAt",
                      "if (radius() < 3.0) return Sphere::getNormalAt(position);");
    const SubmissionResult result = gradeSubmission(work, tests::testGrader(), 1);
    EXPECT_EQ(taskOf(result, "T1").state, TaskState::failed);
    EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"bump.wrong"});
}

SubmissionResult gradeBumps(const std::string& atTheBeginning) {
    intake::Submission work;
    work.name = "somebody";
    work.parts["BumpySphere.cpp"] =
        referenceWith("BumpySphere.cpp", "BumpySphere::getNormalAt", atTheBeginning);
    return gradeSubmission(work, tests::testGraderWithScenes(), 1);
}

// If the spheres of questions had a material that no scene has, code could tell them by it.
TEST(Dishonest, BumpsOnBlackSpheresAloneFail) {
    const SubmissionResult result =
        gradeBumps("if (colour().r > 0.0) return Sphere::getNormalAt(position);");
    EXPECT_EQ(taskOf(result, "T1").state, TaskState::failed);
}

TEST(Dishonest, BumpsThatThePictureDoesNotShowAreLeftToAPerson) {
    for (const char* trick :
         {"if (heightMap().width() == 1024 && heightMap().height() == 512) "
          "return Sphere::getNormalAt(position);",
          "static void* const first = __builtin_return_address(0);"
          "if (__builtin_return_address(0) != first) return Sphere::getNormalAt(position);"}) {
        const SubmissionResult result = gradeBumps(trick);
        EXPECT_EQ(taskOf(result, "T1").state, TaskState::passed) << trick;
        EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"bump.picture-differs"}) << trick;
        EXPECT_EQ(result.verdict, Verdict::needsReview) << trick;
    }
}

TEST(Dishonest, BumpsOfACodeThatLeavesBeforeThePictureAreLeftToAPerson) {
    const SubmissionResult result = gradeBumps("if (heightMap().width() == 2048) std::abort();");
    EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{"bump.picture-differs"});
}

// Weak bumps change the picture little, and strong ones turn reflections round.
TEST(Honest, BumpsOfAnyStrengthShowInThePicture) {
    for (const char* strength : {"0.02", "0.2", "1.0", "20.0"}) {
        std::string source = tests::readFile("reference_solution/exercise/BumpySphere.cpp");
        for (const std::string term : {"Bu * normal.cross(Pv)", "Bv * normal.cross(Pu)"})
            source.insert(source.find(term), std::string{strength} + " * ");
        intake::Submission work;
        work.name = "somebody";
        work.parts["BumpySphere.cpp"] = source;
        const SubmissionResult result = gradeSubmission(work, tests::testGraderWithScenes(), 1);
        EXPECT_EQ(taskOf(result, "T1").state, TaskState::passed) << strength;
        EXPECT_EQ(findingIds(taskOf(result, "T1")), Ids{}) << strength;
    }
}

TEST(Honest, LightsThatAreLostBehindASurfaceAreNamed) {
    intake::Submission work;
    work.name = "somebody";
    for (const char* mistake : {"if (N.dot(light.position() - P) <= 0.0) break;",
                                "if (N.dot(light.position() - P) <= 0.0) return colour;"}) {
        work.parts["Renderer.cpp"] =
            referenceWith("Renderer.cpp", "for (const PointLight&", mistake);
        const SubmissionResult result = gradeSubmission(work, tests::testGrader(), 1);
        EXPECT_EQ(findingIds(taskOf(result, "T2.1")), Ids{"shadow.lights-mixed"}) << mistake;
    }
    work.parts["Renderer.cpp"] = referenceWith("Renderer.cpp", "for (const PointLight&",
                                               "if (N.dot(light.position() - P) <= 0.0) continue;");
    const SubmissionResult spared = gradeSubmission(work, tests::testGrader(), 1);
    EXPECT_EQ(taskOf(spared, "T2.1").state, TaskState::passed) << "nothing comes from there";
}

TEST(DoubtPicture, AddsAFindingOnlyIfBothTasksPassed) {
    for (const auto& [shadows, lens] : {std::pair{TaskState::failed, TaskState::passed},
                                        std::pair{TaskState::passed, TaskState::failed},
                                        std::pair{TaskState::passed, TaskState::notAttempted}}) {
        std::vector<TaskReport> tasks = reports(shadows, lens);
        tasks::doubtPicture(tasks, {{1.0, 100.0}}, std::nullopt);
        EXPECT_TRUE(tasks[1].findings.empty());
        EXPECT_FALSE(tasks[1].needsReview);
    }
}

// Misfits of right solutions: 0.04 (stratified points) to 1.05 (points that crowd on the surface).
TEST(DoubtPicture, TakesNoiseForNoise) {
    std::vector<TaskReport> tasks = reports(TaskState::passed, TaskState::passed);
    tasks::doubtPicture(tasks, {{1.0, 1.05}}, 1.0);
    EXPECT_TRUE(tasks[1].findings.empty());
    tasks::doubtPicture(tasks, {{1.0, 1.2}, {0.5, 4.0}}, 1.0);
    EXPECT_EQ(findingIds(tasks[1]), Ids{"dof.picture-differs"});
}

TEST(DoubtPicture, WantsTheApertureThatTheAnswersShow) {
    const std::vector<Misfit> half{{1.0, 5.0}, {0.5, 0.7}};
    std::vector<TaskReport> tasks = reports(TaskState::passed, TaskState::passed);
    tasks::doubtPicture(tasks, half, 0.5);
    tasks::doubtPicture(tasks, half, std::nullopt);
    EXPECT_TRUE(tasks[1].findings.empty());
    tasks::doubtPicture(tasks, half, 1.0);
    ASSERT_EQ(findingIds(tasks[1]), Ids{"dof.picture-differs"});
    EXPECT_NE(tasks[1].findings[0].message.find("half-width 0.2 in small pictures, the picture of "
                                                "the handout's scene has the blur of 0.1"),
              std::string::npos);
    EXPECT_TRUE(tasks[1].needsReview);
}

TEST(DoubtPicture, AllowsMoreToOnePatternForAllPixels) {
    std::vector<TaskReport> tasks = reports(TaskState::passed, TaskState::passed);
    tasks[1].findings.push_back({});
    tasks[1].findings[0].id = "dof.reused-pattern";
    tasks::doubtPicture(tasks, {{1.0, 1.5}}, 1.0);
    EXPECT_FALSE(tasks[1].needsReview);
    tasks::doubtPicture(tasks, {{1.0, 2.1}}, 1.0);
    EXPECT_TRUE(tasks[1].needsReview);
}

TEST(DoubtPicture, IsContentWithReadingsThatExplainAnotherPicture) {
    for (const char* id : {"shadow.view-from-eye", "shadow.near-side-falloff", "dof.antialiased"}) {
        std::vector<TaskReport> tasks = reports(TaskState::passed, TaskState::passed);
        tasks[0].findings.push_back({});
        tasks[0].findings[0].id = id;
        tasks::doubtPicture(tasks, {{1.0, 70.0}}, std::nullopt);
        EXPECT_FALSE(tasks[1].needsReview) << id;
        tasks::doubtPicture(tasks, {}, std::nullopt);
        EXPECT_TRUE(tasks[1].needsReview) << "no picture came";
    }
}

}  // namespace
}  // namespace ticker::pipeline
