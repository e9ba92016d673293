// Lights that add little, close lights, the back side of a surface, and eight lights.
#include <grader/tasks/support/Surfaces.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

/// @param height  Of the light over the floor; the light is 12 away.
std::optional<Finding> judgeFaint(double height, int rays, double lightTimes,
                                  bool raysAreVisible = true) {
    ShadowByHand made;
    ShadowQuestion& asked =
        made.ask(Purpose::faintLight, {{std::sqrt(144.0 - height * height), height, 0.0}});
    asked.question.scene.ambientLighting = ColourRGB{0.01};
    asked.question.scene.planes[0].material.colour = ColourRGB{0.5};
    PointLog& point = made.point({0.5, 0.0, 0.3});  // not at the eye
    made.castArc(rays);
    const raytracer::SceneDescription& scene = made.last().scene();
    point.colour = ambientPart(point, scene) + unshadowed(point, scene, 0, false) * lightTimes;
    return raysAreVisible ? checkFaintLight(made.logs()) : checkFaintValues(made.logs(), {});
}

TEST(CheckFaintLight, WantsAllOfItsLight) {
    EXPECT_FALSE(judgeFaint(12.0, 10, 1.0));
    const auto cut = judgeFaint(12.0, 10, 0.0);
    ASSERT_EQ(idOf(cut), "shadow.wrong");
    EXPECT_NE(cut->message.find("less than 0.01"), std::string::npos) << cut->message;
    const auto faded = judgeFaint(1.0, 10, 0.5);
    ASSERT_EQ(idOf(faded), "shadow.wrong");
    EXPECT_NE(faded->message.find("shines along the surface"), std::string::npos) << faded->message;
}

TEST(CheckFaintLight, WantsItsLightWhereNoRayIsVisible) {
    EXPECT_FALSE(judgeFaint(12.0, 0, 1.0, false));
    EXPECT_EQ(idOf(judgeFaint(12.0, 0, 0.0, false)), "shadow.wrong");
    EXPECT_EQ(idOf(judgeFaint(1.0, 0, 0.0, false)), "shadow.wrong");
}

TEST(CheckFaintLight, WantsItsRays) {
    EXPECT_FALSE(judgeFaint(12.0, 11, 1.0));
    const auto skipped = judgeFaint(12.0, 0, 0.0);
    ASSERT_EQ(idOf(skipped), "shadow.too-few-rays");
    EXPECT_EQ(numberIn(*skipped, "fewestRays"), 0.0);
}

/// @param off       Distance of the aims from the light's centre.
/// @param distinct  Number of different aims at a far light.
std::optional<Finding> judgeClose(double off, std::size_t distinct = 2010) {
    ShadowByHand made;
    made.ask(Purpose::closeLight, {{0.0, 1.3, 0.0}});
    for (int i = 0; i < 30; ++i) {
        made.point();
        made.castArc(10, 0, off);
    }
    AimVerdict aims;
    aims.distinct = distinct;
    return checkCloseLight(made.logs(), aims);
}

TEST(CheckCloseLight, WantsRaysBeyondSevenTenthsOfTheRadius) {
    EXPECT_FALSE(judgeClose(0.4));
    EXPECT_FALSE(judgeClose(0.3));
    EXPECT_EQ(idOf(judgeClose(0.28)), "shadow.light-size");
    EXPECT_FALSE(judgeClose(0.22, 10)) << "ten aims say little";
}

/// @param off   Distance of the rays from the light's centre.
/// @param rays  From each of 48 points.
std::optional<Finding> judgeOneRay(double off, int rays = 1, std::size_t distinct = 2010) {
    ShadowByHand made;
    made.ask(Purpose::oneRay, {{0.0, 6.0, 0.0}}).question.settings.shadowRayCount = 1;
    for (int i = 0; i < 48; ++i) {
        made.point();
        made.castArc(rays, 0, off);
    }
    AimVerdict aims;
    aims.distinct = distinct;
    return checkOneRay(made.logs(), aims);
}

TEST(CheckOneRay, WantsSomeOfThemAwayFromTheCentre) {
    EXPECT_FALSE(judgeOneRay(0.13));
    const auto all = judgeOneRay(0.0);
    ASSERT_EQ(idOf(all), "shadow.fixed-samples");
    EXPECT_EQ(all->severity, Severity::warn);
    EXPECT_EQ(idOf(judgeOneRay(0.1, 2)), "shadow.fixed-samples");
    EXPECT_FALSE(judgeOneRay(0.0, 1, 10)) << "ten aims say little";
}

/// @param share  Of the diffuse light that a surface facing the other way would have.
std::optional<Finding> judgeBackSide(double share) {
    ShadowByHand made;
    raytracer::SceneDescription& asked =
        made.ask(Purpose::backSide, {{0.0, -6.0, 0.0}}).question.scene;
    asked.ambientLighting = ColourRGB{0.5};
    asked.planes[0].material.colour = ColourRGB{0.5};
    PointLog& point = made.point();
    const raytracer::SceneDescription& scene = made.last().scene();
    PointLog turned = point;
    turned.point.normal = -point.point.normal;
    point.colour = ambientPart(point, scene) + unshadowed(turned, scene, 0, false) * share;
    return checkBackSide(made.logs());
}

TEST(CheckBackSide, WantsAmbientLightAlone) {
    EXPECT_FALSE(judgeBackSide(0.0));
    EXPECT_EQ(idOf(judgeBackSide(0.1)), "shadow.wrong");
    EXPECT_EQ(idOf(judgeBackSide(1.0)), "shadow.wrong");
}

// This holds whether V points to O or to the eye, and whether or not code looks for the surface's
// own shadow.
TEST(BackSide, HasNoHighlightInAnyReading) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        for (const ShadowQuestion& question : drawShadowQuestions(seed)) {
            if (question.purpose != Purpose::backSide) continue;
            for (const probe::LitPoint& point : question.question.points) {
                const Vector3 towards =
                    question.question.scene.pointLights[0].position() - point.position;
                const Vector3 mirrored = towards.normalised().reflectIn(point.normal);
                EXPECT_LT(towards.dot(point.normal), 0.0);
                EXPECT_LT((point.viewer - point.position).dot(point.normal), 0.0);
                for (const Vector3& viewer : {point.viewer, Vector3{}})
                    EXPECT_LT(mirrored.dot((viewer - point.position).normalised()), -0.1);
            }
        }
    }
}

/// @param rays  To the last of eight lights, which adds this share of its light.
std::optional<Finding> judgeEight(int rays, double share, bool raysAreVisible = true) {
    ShadowByHand made;
    std::vector<Vector3> lights;
    for (int i = 0; i < 8; ++i)
        lights.push_back({7.0 * std::cos(0.785 * i), 4.0, 7.0 * std::sin(0.785 * i)});
    made.ask(Purpose::eightLights, lights).question.scene.planes[0].material.colour =
        ColourRGB{0.5};
    PointLog& point = made.point({0.5, 0.0, 0.3});
    const raytracer::SceneDescription& scene = made.last().scene();
    point.colour = ambientPart(point, scene);
    for (std::size_t i = 0; i < 8; ++i) {
        made.castArc(i < 7 ? 10 : rays, i);
        point.colour += unshadowed(point, scene, i, false) * (i < 7 ? 1.0 : share);
    }
    return raysAreVisible ? checkEightLights(made.logs(), {}, false)
                          : checkEightValues(made.logs(), {});
}

TEST(CheckEightLights, WantsRaysAndLightOfTheLast) {
    EXPECT_FALSE(judgeEight(10, 1.0));
    EXPECT_EQ(idOf(judgeEight(0, 0.0)), "shadow.lights-mixed");
    EXPECT_EQ(idOf(judgeEight(9, 1.0)), "shadow.too-few-rays");
    EXPECT_EQ(idOf(judgeEight(10, 3.0)), "shadow.lights-mixed");
    EXPECT_FALSE(judgeEight(0, 1.0, false));
    EXPECT_EQ(idOf(judgeEight(0, 4.0, false)), "shadow.lights-mixed");
}

TEST(FaintLights, AreInPlainSightAboveTheHorizonUnderEverySeed) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        int found = 0;
        for (const ShadowQuestion& question : drawShadowQuestions(seed)) {
            if (question.purpose != Purpose::faintLight && question.purpose != Purpose::closeLight)
                continue;
            ++found;
            const raytracer::SceneDescription& scene = question.question.scene;
            const Surfaces surfaces{scene};
            const double size = question.question.settings.lightSize;
            for (const probe::LitPoint& point : question.question.points) {
                const Vector3 towards = scene.pointLights[0].position() - point.position;
                EXPECT_GT(towards.dot(point.normal), size * 4.0 / 3.0);
                EXPECT_GT(towards.magnitude(), 1.38 * size);
                const Vector3 way = towards.normalised();
                EXPECT_EQ(surfaces.sightAlong(point.position + point.normal * 1e-4, way,
                                              towards.magnitude()),
                          Sight::open);
            }
        }
        EXPECT_EQ(found, 4);
    }
}

}  // namespace
}  // namespace ticker::tasks
