// Pictures by code that does not draw the same one again.
#include <grader/picture/EncodePicture.h>
#include <grader/pipeline/Grade.h>
#include <grader/pipeline/RenderSubmission.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ticker::pipeline {
namespace {

using tests::findingIds;
using tests::taskOf;
using Ids = std::vector<std::string>;

// In its sample this picture counts as that of other code, since the code there draws the same
// picture each time. Code whose threads race does not.
TEST(Honest, NothingIsSaidAgainstThePictureOfCodeWhoseThreadsRace) {
    intake::Submission work;
    work.name = "somebody";
    std::string source = tests::readFile("reference_solution/exercise/Renderer.cpp");
    const std::string count = "int reached = 0;";
    source.replace(source.find(count), count.size(), "static int reached; reached = 0;");
    work.parts["Renderer.cpp"] = source;
    work.parts["screenshot.png"] =
        tests::readFile("grader/corpus/samples/needsReview/picture-of-other-code/screenshot.png");
    const SubmissionResult result = gradeSubmission(work, tests::testGraderWithScenes(), 1);
    EXPECT_EQ(findingIds(taskOf(result, "T2.1")), Ids{"shadow.threads-mixed"});
    const TaskReport& picture = taskOf(result, "screenshot");
    EXPECT_EQ(picture.state, TaskState::passed);
    EXPECT_EQ(findingIds(picture), Ids{"screenshot.unverified"});
}

/// The reference with lens points from a table that each process draws anew.
/// @param index  Expression for the index of a ray's point in the table.
intake::Submission withATableOfLensPoints(const std::string& index) {
    std::string source = tests::readFile("reference_solution/exercise/Renderer.cpp");
    const std::size_t begin = source.find("const Vector3 lensPoint{");
    const std::string end = "0.0};";
    source.replace(begin, source.find(end, begin) + end.size() - begin,
                   "const Vector3 lensPoint = lensPoints()[(" + index +
                       ") % lensPoints().size()] * settings().dofAmount;");
    source.insert(source.find("namespace raytracer"),
                  "#include <random>\n#include <vector>\n"
                  "static const std::vector<raytracer::Vector3>& lensPoints() {\n"
                  "static const std::vector<raytracer::Vector3> points = [] {\n"
                  "std::mt19937_64 generator{std::random_device{}()};\n"
                  "std::uniform_real_distribution<double> side{-1.0, 1.0};\n"
                  "std::vector<raytracer::Vector3> drawn(50 << 12);\n"
                  "for (auto& point : drawn) point = {side(generator), side(generator), 0.0};\n"
                  "return drawn; }();\nreturn points; }\n");
    intake::Submission work;
    work.name = "somebody";
    work.parts["Renderer.cpp"] = source;
    return work;
}

// The picture comes from another process than the answers. One table for all pixels makes pictures
// that differ by more than noise.
TEST(Honest, NothingIsSaidAgainstThePictureOfCodeThatDrawsATableInEachProcess) {
    const Grader& grader = tests::testGraderWithScenes();
    const auto scene = std::ranges::find(grader.scenes, "distributed", &SpecScene::name);
    ASSERT_NE(scene, grader.scenes.end());
    raytracer::RenderSettings settings = scene->settings;
    settings.width = 320;  // the smallest width that the grader accepts
    settings.height = 240;
    for (const char* index : {"i", "(y * settings().width + x) * 50 + i"}) {
        intake::Submission work = withATableOfLensPoints(index);
        work.parts["screenshot.png"] =
            picture::encodePicture(renderSubmission(work, grader, scene->scene, settings));
        const SubmissionResult result = gradeSubmission(work, grader, 1);
        const TaskReport& picture = taskOf(result, "screenshot");
        EXPECT_EQ(picture.state, TaskState::passed) << index;
        EXPECT_FALSE(picture.needsReview) << index;
        for (const Finding& finding : picture.findings)
            EXPECT_EQ(finding.id, "screenshot.unverified") << index << ": " << finding.message;
    }
}

}  // namespace
}  // namespace ticker::pipeline
