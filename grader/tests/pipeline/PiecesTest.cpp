// Steps of the pipeline alone, with made-up scenes, pictures and files: nothing is compiled.
#include <grader/picture/EncodePicture.h>
#include <grader/pipeline/DrawRasters.h>
#include <grader/pipeline/FileWork.h>
#include <grader/pipeline/Fit.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <future>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace ticker::pipeline {
namespace {

/// An expected picture of one brightness, and the aperture of the reading that it belongs to.
struct Look {
    double brightness;
    double apertureFactor;
};

constexpr int kSide = 6;

std::shared_future<Expectation> lookOf(double brightness) {
    Expectation expected;
    expected.brightness.renders = 1e12;
    expected.brightness.mean = {kSide, kSide, std::vector<float>(kSide * kSide)};
    expected.brightness.variance = {kSide, kSide, std::vector<float>(kSide * kSide, 1.0F)};
    for (float& value : expected.brightness.mean.values)
        value = static_cast<float>(brightness);
    std::promise<Expectation> promise;
    promise.set_value(std::move(expected));
    return promise.get_future().share();
}

/// Which of the looks fits a black picture best, how many were tried, and whether the fit leaves no
/// doubt. With a variance of 1 a look's misfit is the square of its brightness.
struct Chosen {
    std::size_t look;
    std::size_t tried;
    bool isClear;

    bool operator==(const Chosen&) const = default;
};

/// A random scene whose accepted readings give these looks.
SpecScene sceneOf(const std::vector<Look>& looks) {
    SpecScene scene;
    scene.isRandom = true;
    // As many rays as a picture of few rays has, so that both have the same noise.
    scene.settings.dofRayCount = kFewRays;
    for (const Look& look : looks) {
        scene.expectations.push_back(lookOf(look.brightness));
        scene.readings.emplace_back();
        scene.readings.back().apertureFactor = look.apertureFactor;
    }
    return scene;
}

probe::RenderAnswer blackPicture() {
    probe::RenderAnswer answer;
    answer.width = answer.height = kSide;
    answer.images = {std::vector<probe::ColourRGB>(kSide * kSide)};
    return answer;
}

/// The first of the scene's looks that has the brightness of this expectation.
std::size_t indexOf(const SpecScene& scene, const Expectation& expected) {
    const auto brightnessesOf = [](const Expectation& any) -> const std::vector<float>& {
        return any.brightness.mean.values;
    };
    const auto found = std::ranges::find_if(scene.expectations, [&](const auto& each) {
        return brightnessesOf(each.get()) == brightnessesOf(expected);
    });
    return static_cast<std::size_t>(found - scene.expectations.begin());
}

Chosen choose(const std::vector<Look>& looks, Rays rays = Rays::handout) {
    const SpecScene scene = sceneOf(looks);
    const Fit fit = bestFit(scene, blackPicture(), rays);
    return {indexOf(scene, *fit.expected), fit.misfits.size(), fit.isClear};
}

TEST(BestFit, StopsAtTheFirstLookThatFits) {
    EXPECT_EQ(choose({{1.04, 1.0}, {0.0, 0.5}, {0.0, 1.0}}), (Chosen{0, 1, true}));
    EXPECT_EQ(choose({{1.06, 1.0}, {0.5, 0.5}, {0.0, 1.0}}), (Chosen{1, 2, true}));
}

TEST(BestFit, KeepsTheBetterOfTwoApertures) {
    EXPECT_EQ(choose({{2.0, 1.0}, {3.0, 0.5}}), (Chosen{0, 2, true}));
    EXPECT_EQ(choose({{3.0, 1.0}, {2.0, 0.5}}), (Chosen{1, 2, true}));
}

TEST(BestFit, TriesOtherLightsOfTheBetterApertureThatNearlyFits) {
    EXPECT_EQ(choose({{1.4, 1.0}, {3.0, 0.5}, {0.0, 0.5}, {0.1, 1.0}}), (Chosen{3, 3, true}));
    EXPECT_EQ(choose({{1.42, 1.0}, {3.0, 0.5}, {0.0, 0.5}, {0.1, 1.0}}), (Chosen{0, 2, true}))
        << "a misfit of more than 2 is no reading of the light";
}

// A tile of 3 x 3 pixels adds up to three times the brightness.
TEST(BestFit, AddsTilesUpWhereThereAreFewRays) {
    EXPECT_EQ(choose({{0.32, 1.0}, {0.0, 0.5}}, Rays::few), (Chosen{0, 1, true}));
    EXPECT_EQ(choose({{0.33, 1.0}, {0.0, 0.5}, {0.4, 1.0}}, Rays::few), (Chosen{0, 2, false}))
        << "another aperture is not tried where this one nearly fits";
    EXPECT_EQ(choose({{0.5, 1.0}, {0.1, 0.5}}, Rays::few), (Chosen{1, 2, true}));
}

TEST(BrightnessOf, WeighsGreenTwice) {
    const metrics::Map map =
        brightnessOf(3, 1, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}});
    EXPECT_EQ(map.values, (std::vector<float>{0.25F, 0.5F, 0.25F}));
    EXPECT_EQ(map.width, 3);
}

TEST(DrawRasters, ShowsGreysFromBlackToWhiteAndNaNAsBlack) {
    SubmissionResult result;
    result.tasks.resize(1);
    result.tasks[0].id = "T1";
    Raster raster;
    raster.title = "relief";
    raster.width = 5;
    raster.height = 1;
    raster.values = {-0.5F, 0.5F, 1.0F, 2.0F, std::numeric_limits<float>::quiet_NaN()};
    raster.colours = Raster::Colours::grey;
    result.tasks[0].rasters = {raster, raster};
    result.tasks[0].findings.resize(1);
    result.tasks[0].findings[0].rasters = {raster};
    drawRasters(result);
    ASSERT_EQ(result.pictures.size(), 3U);
    raytracer::ByteImage wanted{5, 1, {}};
    for (const int grey : {0, 127, 255, 255, 0})
        wanted.rgb.insert(wanted.rgb.end(), 3, static_cast<std::uint8_t>(grey));
    for (const ResultPicture& picture : result.pictures)
        EXPECT_EQ(picture.png, picture::encodePicture(wanted));
    EXPECT_EQ(result.tasks[0].findings[0].rasters[0].image, "images/T1-1.png");
    EXPECT_EQ(result.tasks[0].rasters[1].image, "images/T1-3.png");
}

TEST(IsOpen, IsAReportWithoutAReasonThatNobodyJudgedYet) {
    TaskReport task;
    task.state = TaskState::notGraded;
    EXPECT_TRUE(awaitsJudge(task));
    task.reason = "the program could not be run";
    EXPECT_FALSE(awaitsJudge(task));
    task.reason = "";
    task.state = TaskState::passed;
    EXPECT_FALSE(awaitsJudge(task));
}

/// The state and the reason of the file's first task.
std::pair<TaskState, std::string> preparedAs(const std::string& option, const std::string& file,
                                             const std::string& source) {
    intake::Submission work;
    if (!source.empty()) work.parts[file] = source;
    Grader grader = tests::testGrader();
    grader.option = option;
    const FileWork prepared = prepareFile(work, file, grader);
    EXPECT_FALSE(prepared.program);
    return {prepared.tasks.at(0).state, prepared.tasks.at(0).reason};
}

TEST(PrepareFile, LooksOnlyAtFilesOfTheChosenOption) {
    const std::string file = "BumpySphere.cpp";
    const std::string stub = tests::testGrader().kit.templateSource(file);
    const Exercise& exercise = *tests::testGrader().exercise;
    int chosen = 0;
    for (const auto& option : exercise.options) {
        const auto [state, reason] = preparedAs(option.name, file, stub);
        EXPECT_EQ(state, TaskState::notAttempted);
        EXPECT_EQ(reason, exercise.isIn(option.name, file) ? "the stub still stands"
                                                           : "another option was to be judged");
        if (exercise.isIn(option.name, file)) ++chosen;
    }
    EXPECT_EQ(chosen, 1);
    EXPECT_EQ(preparedAs("", file, stub).second, "the stub still stands");
    EXPECT_EQ(preparedAs("", file, "").second, "there is no BumpySphere.cpp");
}

}  // namespace
}  // namespace ticker::pipeline
