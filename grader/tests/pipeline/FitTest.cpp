// Pictures of the handout's scene with few rays say what those with all rays say. The students are
// simulated by the oracle, with seeds of their own.
#include <grader/oracle/Oracle.h>
#include <grader/pipeline/Fit.h>
#include <grader/tasks/lens/checks/PictureDoubt.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace ticker::pipeline {
namespace {

const SpecScene& randomScene() {
    static const std::vector<SpecScene> scenes =
        readSpecScenes(std::filesystem::path{TICKER_SOURCE_DIR} / "scenes",
                       std::filesystem::path{TICKER_SOURCE_DIR} / "assets");
    return *std::ranges::find(scenes, true, &SpecScene::isRandom);
}

Fit fitOf(Rays rays, std::uint64_t seed, const oracle::Reading& reading,
          const oracle::Mistake& mistake = {}) {
    const SpecScene& scene = randomScene();
    const raytracer::Image image =
        oracle::Oracle{scene.scene, settingsFor(scene, rays), reading, mistake}.studentRender(seed);
    probe::RenderAnswer answer;
    answer.width = image.width();
    answer.height = image.height();
    answer.images.emplace_back(image.pixels().begin(), image.pixels().end());
    return bestFit(scene, answer, rays);
}

double misfitOf(const Fit& fit) {
    return std::ranges::min_element(fit.misfits, {}, &Misfit::meanSquare)->meanSquare;
}

TEST(FewRays, AreFewerThanTheHandouts) {
    EXPECT_EQ(settingsFor(randomScene(), Rays::few).dofRayCount, kFewRays);
    EXPECT_EQ(settingsFor(randomScene(), Rays::handout).dofRayCount,
              raytracer::RenderSettings{}.dofRayCount);
}

// A picture that is not clear is drawn again: nothing is held against right code here.
TEST(FewRays, AreEnoughForRightCode) {
    for (const double factor : kAcceptedApertures)
        for (std::uint64_t seed = 100; seed < 110; ++seed) {
            oracle::Reading reading;
            reading.apertureFactor = factor;
            const Fit fit = fitOf(Rays::few, seed, reading);
            EXPECT_TRUE(fit.isClear) << misfitOf(fit);
            EXPECT_EQ(fit.misfits.back().apertureFactor, factor);
        }
}

TEST(FewRays, LeaveNoPictureClearThatTheHandoutsRaysWouldNot) {
    std::vector<oracle::Mistake> mistakes(7);
    mistakes[0].lightSizeFactor = 1e-3;
    mistakes[1].lightSizeFactor = 0.4;
    mistakes[2].aperture = oracle::Mistake::Aperture::none;
    mistakes[3].lensOffsetX = 0.1;
    mistakes[4].focalFactor = 0.95;
    mistakes[5].focalByDistance = true;
    mistakes[6].allOrNothing = true;
    for (const oracle::Mistake& mistake : mistakes) {
        const double full = misfitOf(fitOf(Rays::handout, 7, {}, mistake));
        EXPECT_GT(full, tasks::kMostMisfit) << &mistake - mistakes.data();
        for (std::uint64_t seed = 200; seed < 202; ++seed) {
            const Fit few = fitOf(Rays::few, seed, {}, mistake);
            EXPECT_FALSE(few.isClear) << &mistake - mistakes.data() << ": " << misfitOf(few);
        }
    }
}

}  // namespace
}  // namespace ticker::pipeline
