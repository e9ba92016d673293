// Single scenes beside the mixed ones of T2.1: balls, lights and sizes that those do not have.
#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ticker::tasks {
namespace {

using raytracer::PointLight;

constexpr std::uint64_t kSeeds = 40;

TEST(OtherBalls, HideTheLightFromEveryPointUnderEverySeed) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Draw draw{seed, 77};
        int bumpy = 0;
        int large = 0;
        int far = 0;
        for (const ShadowQuestion& drawn : drawOtherBalls(draw)) {
            const raytracer::SphereDescription& ball = drawn.question.scene.spheres.at(0);
            const Vector3 light = drawn.question.scene.pointLights.at(0).position();
            bumpy += ball.heightMap != nullptr ? 1 : 0;
            const Vector3 foot = drawn.question.scene.planes.at(0).point;
            far += (ball.centre - foot).magnitude() - ball.radius > 1000.0 ? 1 : 0;
            bool isFarther = true;
            for (const probe::LitPoint& point : drawn.question.points)
                isFarther = isFarther && (ball.centre - point.position).magnitude() >
                                             (light - point.position).magnitude();
            large += isFarther ? 1 : 0;
            for (const std::vector<Zone>& zones : drawn.zones)
                EXPECT_EQ(zones, std::vector{Zone::umbra}) << seed;
        }
        EXPECT_EQ(bumpy, 3) << seed;
        EXPECT_EQ(large, 3) << seed;
        EXPECT_EQ(far, 1) << seed;
    }
}

TEST(VeryFarLights, AreInPlainSightWhateverTheSeed) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Draw draw{seed, 77};
        std::vector<double> distances;
        for (const ShadowQuestion& drawn : drawVeryFarLights(draw)) {
            const auto& [object, position, normal, viewer] = drawn.question.points.at(0);
            const Vector3 way = drawn.question.scene.pointLights.at(0).position() - position;
            EXPECT_GT(way.normalised().dot(normal), 0.3) << seed;
            distances.push_back(way.magnitude());
        }
        ASSERT_EQ(distances.size(), 3U);
        EXPECT_GT(distances[0], 199.0) << seed;
        EXPECT_GT(distances[1], 1099.0) << seed;
        EXPECT_GT(distances[2], 5999.0) << seed;
    }
}

TEST(ManyLights, AllLightTheirPointsAndTheLastOnesShow) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Draw draw{seed, 77};
        const ShadowQuestion drawn = drawManyLights(draw).at(0);
        const auto& lights = drawn.question.scene.pointLights;
        ASSERT_EQ(lights.size(), 34U);
        for (const probe::LitPoint& point : drawn.question.points) {
            const auto arriving = [&](const PointLight& light) {
                const Vector3 way = light.position() - point.position;
                EXPECT_GT(way.normalised().dot(point.normal), 0.3) << seed;
                return light.illuminationAt(way.magnitude()).g * way.normalised().dot(point.normal);
            };
            double all = 0.0;
            for (const PointLight& light : lights)
                all += arriving(light);
            EXPECT_GT(arriving(lights[32]) + arriving(lights[33]), 0.04 * all) << seed;
        }
    }
}

void expectZonesOfGeometry(const ShadowQuestion& drawn, std::uint64_t seed) {
    const auto& scene = drawn.question.scene;
    ASSERT_EQ(scene.pointLights.size(), 1U);
    for (std::size_t i = 0; i < drawn.zones.size(); ++i) {
        const probe::LitPoint& point = drawn.question.points[i];
        EXPECT_EQ(drawn.zones[i], zonesOf(scene, Surfaces{scene}, point.position, point.normal,
                                          drawn.question.settings.lightSize))
            << seed;
        EXPECT_GT((scene.pointLights[0].position() - point.position).dot(point.normal),
                  1.4 * drawn.question.settings.lightSize)
            << seed;
    }
}

// Code may ignore hits up to 0.02 before the light's ball: some submissions leave such a margin.
TEST(SmallLights, AreInPlainSightOrHiddenFromEveryPoint) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Draw draw{seed, 77};
        const std::vector<ShadowQuestion> drawn = drawSmallLights(draw);
        ASSERT_EQ(drawn.size(), 4U);
        for (const ShadowQuestion& question : drawn)
            expectZonesOfGeometry(question, seed);
        EXPECT_EQ(drawn[0].zones[0], std::vector{Zone::lit});
        EXPECT_EQ(drawn[1].zones[0], std::vector{Zone::lit});
        EXPECT_EQ(drawn[2].zones[0], std::vector{Zone::umbra});
        const auto& scene = drawn[2].question.scene;
        const Vector3 light = scene.pointLights[0].position();
        const double gap = std::abs((light - scene.planes[1].point).dot(scene.planes[1].normal));
        EXPECT_GT(gap, 0.02 + drawn[2].question.settings.lightSize) << seed;
        EXPECT_LT(gap, 0.05 - 1e-3) << seed;
    }
}

// Otherwise code that cuts a large exponent off at 100 would not show.
TEST(SmallLights, ShowAHighlightThatAnExponentOf100WouldMakeBrighter) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Draw draw{seed, 77};
        const ShadowQuestion drawn = drawSmallLights(draw).at(1);
        const auto& scene = drawn.question.scene;
        double most = 0.0;
        for (const probe::LitPoint& point : drawn.question.points) {
            const Vector3 L = (scene.pointLights[0].position() - point.position).normalised();
            const Vector3 V = (point.viewer - point.position).normalised();
            const double cosine = L.reflectIn(point.normal).dot(V);
            most = std::max(most, std::pow(cosine, 100.0) -
                                      std::pow(cosine, scene.planes[0].material.phongAlpha));
        }
        EXPECT_GT(most, 0.05) << seed;
    }
}

// Code that rounds shares shows only there: of about 50 rays a few are blocked, or a few arrive.
TEST(PenumbraEdges, HaveASmallShareOfTheLightHiddenOrVisible) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Draw draw{seed, 77};
        const ShadowQuestion drawn = drawPenumbraEdges(draw).at(0);
        const auto& scene = drawn.question.scene;
        int dark = 0;
        for (const probe::LitPoint& point : drawn.question.points) {
            const double share =
                visibleShare(Surfaces{scene}, point.position + point.normal * 1e-4,
                             scene.pointLights[0].position(), drawn.question.settings.lightSize);
            EXPECT_GT(std::min(share, 1.0 - share), 0.03) << seed;
            EXPECT_LT(std::min(share, 1.0 - share), 0.16) << seed;
            dark += share < 0.5 ? 1 : 0;
        }
        EXPECT_EQ(dark, 8) << seed;
        EXPECT_EQ(drawn.question.points.size(), 16U) << seed;
    }
}

TEST(OtherSizes, AreInPlainSight) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Draw draw{seed, 77};
        const std::vector<ShadowQuestion> drawn = drawOtherSizes(draw);
        ASSERT_EQ(drawn.size(), 2U);
        EXPECT_GT(drawn[0].question.settings.lightSize, 1.0 / 0.72);
        EXPECT_LT(drawn[1].question.settings.lightSize, 0.1);
        for (const ShadowQuestion& question : drawn)
            expectZonesOfGeometry(question, seed);
    }
}

}  // namespace
}  // namespace ticker::tasks
