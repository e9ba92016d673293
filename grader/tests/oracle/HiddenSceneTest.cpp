#include <grader/oracle/references/HiddenScene.h>
#include <grader/tests/oracle/TestScenes.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace ticker::oracle::test {
namespace {

class EveryTask : public testing::TestWithParam<HiddenTask> {};

TEST_P(EveryTask, GetsInformativeScenes) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const HiddenScene hidden = hiddenScene(GetParam(), seed);
        EXPECT_GE(hidden.weakest, leastSeparation(GetParam()));
        EXPECT_EQ(hidden.separations.size(), knownMistakes(GetParam()).size());
        EXPECT_FALSE(hidden.scene.spheres.empty());
        EXPECT_FALSE(hidden.scene.pointLights.empty());
    }
}

TEST_P(EveryTask, GetsTheSameSceneForTheSameSeed) {
    const HiddenScene first = hiddenScene(GetParam(), 4);
    const HiddenScene second = hiddenScene(GetParam(), 4);
    const HiddenScene other = hiddenScene(GetParam(), 5);
    EXPECT_EQ(first.scene.spheres[0].centre, second.scene.spheres[0].centre);
    EXPECT_NE(first.scene.spheres[0].centre, other.scene.spheres[0].centre);
    EXPECT_EQ(first.rejected, second.rejected);
}

INSTANTIATE_TEST_SUITE_P(HiddenScene, EveryTask,
                         testing::Values(HiddenTask::bump, HiddenTask::softShadows,
                                         HiddenTask::depthOfField));

double weakest(const std::vector<Separation>& separations) {
    double result = separations.front().value;
    for (const Separation& separation : separations)
        result = std::min(result, separation.value);
    return result;
}

TEST(Separation, IsSmallWhereNothingCastsAShadow) {
    raytracer::SceneDescription scene = distributedScene();
    scene.spheres.clear();
    raytracer::RenderSettings settings;
    settings.width = 32;
    settings.height = 24;
    EXPECT_LT(weakest(separationsOf(HiddenTask::softShadows, scene, settings)),
              leastSeparation(HiddenTask::softShadows));
}

TEST(Separation, IsSmallWhereTheLensIsTiny) {
    raytracer::RenderSettings settings;
    settings.width = 32;
    settings.height = 24;
    settings.dofAmount = 1e-4;
    EXPECT_LT(weakest(separationsOf(HiddenTask::depthOfField, distributedScene(), settings)),
              leastSeparation(HiddenTask::depthOfField));
}

}  // namespace
}  // namespace ticker::oracle::test
