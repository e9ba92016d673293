#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/support/Surfaces.h>
#include <grader/tests/tasks/maintick/RightAnswers.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

constexpr std::uint64_t kCheckSeeds = 40;

/// Changes the scene of a question about a point, as code with a condition would see it.
using Change = std::function<void(raytracer::SceneDescription&, const probe::LitPoint&)>;

std::vector<probe::Answer> answersTo(std::vector<probe::Question> questions,
                                     const Change& change = {}) {
    std::vector<probe::Answer> answers;
    for (probe::Question& question : questions) {
        if (auto* lit = std::get_if<probe::IlluminateQuestion>(&question); lit && change)
            change(lit->scene, lit->points.at(0));
        answers.push_back(rightAnswer(question));
    }
    return answers;
}

std::optional<Finding> ofPoints(std::uint64_t seed, const Change& change = {}) {
    const auto points = drawMixedPoints(seed);
    std::vector<probe::Question> questions;
    askMixedPoints(points, questions);
    return checkMixedPoints(points, answersTo(questions, change));
}

std::optional<Finding> ofShades(std::uint64_t seed, const Change& change = {}) {
    const auto shades = drawMixedShades(seed);
    std::vector<probe::Question> questions;
    askMixedShades(shades, questions);
    return checkMixedShades(shades, answersTo(questions, change));
}

TEST(MixedChecks, FindNothingInRightAnswers) {
    for (std::uint64_t seed = 0; seed < kCheckSeeds; ++seed) {
        EXPECT_FALSE(ofPoints(seed)) << seed;
        EXPECT_FALSE(ofShades(seed)) << seed;
        const auto mirrors = drawMixedMirrors(seed);
        std::vector<probe::Question> questions;
        askMixedMirrors(mirrors, questions);
        EXPECT_FALSE(checkMixedMirrors(mirrors, answersTo(questions))) << seed;
    }
}

/// Expects this finding under every seed, and under at least half of them a hint with the trait
/// that the wrong points share.
void expectTold(const std::function<std::optional<Finding>(std::uint64_t)>& judge,
                const std::string& id, const std::string& trait) {
    std::uint64_t told = 0;
    for (std::uint64_t seed = 0; seed < kCheckSeeds; ++seed) {
        const auto finding = judge(seed);
        ASSERT_TRUE(finding) << trait << ", seed " << seed;
        EXPECT_EQ(finding->id, id) << trait << ", seed " << seed << ": " << finding->message;
        if (finding->hint.find(trait) != std::string::npos) ++told;
    }
    EXPECT_GE(told, kCheckSeeds / 2) << trait;
}

TEST(MixedChecks, SayWhatWrongPointsHaveInCommon) {
    const auto changed = [](const Change& change) {
        return [change](std::uint64_t seed) { return ofPoints(seed, change); };
    };
    expectTold(changed([](auto& scene, const probe::LitPoint& at) {
                   if (tasks::materialOf(scene, at.object).phongKD == 0.0)
                       scene.ambientLighting = {};
               }),
               "phong.ambient", "phongKD 0");
    expectTold(changed([](auto& scene, const probe::LitPoint& at) {
                   if (at.position.z < 0.0) scene.pointLights.clear();
               }),
               "phong.wrong", "z below 0");
}

TEST(MixedChecks, CountMistakesOfM2NotAgainInM32) {
    for (std::uint64_t seed = 0; seed < kCheckSeeds; ++seed)
        EXPECT_FALSE(ofShades(seed, [](auto& scene, const probe::LitPoint& at) {
            if (at.position.z < 0.0) scene.ambientLighting = ColourRGB{0.7};
            for (auto& light : scene.pointLights)
                light = {light.position(), light.colour(), light.intensity() * 2.0};
        })) << seed;
}

// If a light is lost only among other objects, the scene alone, without them, is right. The mistake
// is then one of M3.2, not of M2.
TEST(MixedChecks, LeaveLightsThatAreLostInTheSceneAloneToM32) {
    const Change lost = [](auto& scene, const probe::LitPoint&) {
        if (scene.spheres.size() + scene.planes.size() > 1 && !scene.pointLights.empty())
            scene.pointLights.pop_back();
    };
    for (std::uint64_t seed = 0; seed < kCheckSeeds; ++seed) {
        EXPECT_FALSE(ofPoints(seed, lost)) << seed;
        EXPECT_TRUE(ofShades(seed, lost)) << seed;
    }
}

/// Takes all objects of reflectivity 1 out of the way, except the point's own.
void takeWholeMirrors(raytracer::SceneDescription& scene, const probe::LitPoint& at) {
    int object = 0;
    const auto isTaken = [&](const raytracer::Material& material) {
        return object++ != at.object && material.reflectivity == 1.0;
    };
    for (auto& sphere : scene.spheres)
        if (isTaken(sphere.material)) sphere.radius = 1e-9;
    for (auto& plane : scene.planes)
        if (isTaken(plane.material)) {
            plane.point = at.position - at.normal * 1e3;
            plane.normal = at.normal;
        }
}

TEST(MixedChecks, SayWhatBlockersHaveInCommon) {
    expectTold([](std::uint64_t seed) { return ofShades(seed, takeWholeMirrors); }, "shade.wrong",
               "reflectivity 1");
}

}  // namespace
}  // namespace ticker::tasks::maintick
