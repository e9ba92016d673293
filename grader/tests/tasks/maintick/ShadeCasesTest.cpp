#include <grader/tasks/maintick/ShadeCases.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace ticker::tasks::maintick {
namespace {

constexpr double kSlack = 1e-3;  ///< the largest bias of a right shadow ray

Vector3 lightOf(const LitSetup& setup) {
    return setup.scene.pointLights.at(0).position();
}

/// Where the ray meets the object of the point.
std::optional<Meeting> meetOwn(const ShadeCase& shade, const LitSetup& setup, const Ray& ray) {
    return shade.object == 0 ? meet(setup.scene.spheres.at(0), ray)
                             : meet(setup.scene.planes.at(0), ray);
}

/// How much nearer to the light than P the first hit of a ray from the light is; negative: P is
/// nearer.
double beforeP(const ShadeCase& shade, const LitSetup& setup) {
    const Vector3 way = setup.P - lightOf(setup);
    const Ray ray{lightOf(setup), way.normalised()};
    double nearest = meetOwn(shade, setup, ray).value().distance;
    for (const auto& sphere : setup.scene.spheres)
        if (const auto at = meet(sphere, ray)) nearest = std::min(nearest, at->distance);
    for (const auto& plane : setup.scene.planes)
        if (const auto at = meet(plane, ray)) nearest = std::min(nearest, at->distance);
    return way.magnitude() - nearest;
}

TEST(ShadeCases, LieOnTheirObjectWhereTheLightMeetsItFirst) {
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        for (const ShadeCase& shade : drawShadeCases(seed)) {
            EXPECT_LT(std::abs(beforeP(shade, shade.free)), 1e-11) << seed;
            if (shade.place == Occluder::ofSecondLight) continue;
            const double before = beforeP(shade, shade.asked);
            if (shade.isShaded())
                EXPECT_GT(before, 10.0 * kSlack) << seed << ": " << wordsOf(shade.place);
            else
                EXPECT_LT(std::abs(before), 1e-11) << seed << ": " << wordsOf(shade.place);
        }
}

// Whether a ray from P itself meets its own surface depends on how P was rounded. Renders have
// points of both kinds.
TEST(ShadeCases, LieBelowTheirSurfaceAsOftenAsAbove) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        std::size_t sunk = 0;
        const auto cases = drawShadeCases(seed);
        for (const ShadeCase& shade : cases) {
            const Vector3 L = (lightOf(shade.asked) - shade.asked.P).normalised();
            const auto own = meetOwn(shade, shade.asked, {shade.asked.P, L});
            EXPECT_EQ(own.has_value(), shade.isSunk) << seed << ": " << wordsOf(shade.place);
            EXPECT_LT(own ? own->distance : 0.0, 1e-11) << seed;
            EXPECT_FALSE(
                meetOwn(shade, shade.asked, {shade.asked.P + shade.asked.N * 1e-6, L}).has_value())
                << seed;
            if (shade.isSunk) ++sunk;
        }
        EXPECT_EQ(2 * sunk, cases.size());
    }
}

TEST(ShadeCases, HaveSpheresAroundEitherEndAndLightThatGrazes) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        int aroundLight = 0;
        int aroundPoint = 0;
        int aroundBoth = 0;
        int grazing = 0;
        for (const ShadeCase& shade : drawShadeCases(seed)) {
            const LitSetup& setup = shade.asked;
            const double facing = (lightOf(setup) - setup.P).normalised().dot(setup.N);
            EXPECT_GT(facing, 0.0199) << seed;
            if (facing < 0.0401) ++grazing;
            EXPECT_EQ(facing < 0.1, shade.place == Occluder::grazing) << seed;
            if (setup.scene.spheres.size() < 2) continue;
            const auto& ball = setup.scene.spheres[1];
            const auto isInside = [&](const Vector3& at) {
                return (at - ball.centre).magnitude() < ball.radius - 0.1;
            };
            if (isInside(lightOf(setup)) && !isInside(setup.P)) ++aroundLight;
            if (isInside(setup.P) && !isInside(lightOf(setup))) ++aroundPoint;
            if (isInside(setup.P) && isInside(lightOf(setup))) ++aroundBoth;
        }
        EXPECT_EQ(aroundLight, 6) << seed;
        EXPECT_EQ(aroundPoint, 4) << seed;
        EXPECT_EQ(aroundBoth, 2) << seed;
        EXPECT_EQ(grazing, 4) << seed;
    }
}

// For a far light, a tolerance that is a share of the distance is large, and the light still
// counts.
TEST(ShadeCases, HaveSomethingAtEitherEndOfTheWayToAFarLight) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        int far = 0;
        for (const ShadeCase& shade : drawShadeCases(seed)) {
            const Vector3 way = lightOf(shade.asked) - shade.asked.P;
            if (way.magnitude() < 90.0) continue;
            ++far;
            const auto hit = meet(shade.asked.scene.spheres.at(1),
                                  {shade.asked.P + shade.asked.N * kSlack, way.normalised()});
            ASSERT_TRUE(hit) << seed;
            const double fromLight = way.magnitude() - hit->distance;
            EXPECT_EQ(fromLight > 0.0, shade.isShaded()) << seed;
            const double nearest = std::min(hit->distance, std::abs(fromLight));
            EXPECT_GT(nearest, 0.002 * way.magnitude()) << seed;
            EXPECT_LT(nearest, 0.005 * way.magnitude()) << seed;
            EXPECT_FALSE(isNear(phong(shade.free), phong(shade.without), 1e-2)) << seed;
        }
        EXPECT_EQ(far, 6) << seed;
    }
}

TEST(ShadeCases, LetPointsFloatAboveTheirObjectForCodeThatShadesItself) {
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        for (const ShadeCase& shade : drawShadeCases(seed)) {
            const LitSetup& floating = shade.floating;
            for (const auto& light : floating.scene.pointLights) {
                const Vector3 L = (light.position() - floating.P).normalised();
                for (const Vector3& way : {L, -L})
                    EXPECT_FALSE(
                        meet(floating.scene.spheres.at(0), {floating.P - floating.N * kSlack, way}))
                        << seed;
            }
            EXPECT_EQ(floating.O.x, shade.free.O.x) << seed;
        }
}

TEST(LitQuestions, AskTheSameOfAPointOnItsSurface) {
    for (std::uint64_t seed = 0; seed < 200; ++seed)
        for (const LitQuestion& asked : drawLitQuestions(seed)) {
            const LitSetup there = onItsSurface(asked.setup);
            EXPECT_TRUE(isNear(phong(there), phong(asked.setup))) << seed;
            for (const auto& light : there.scene.pointLights) {
                const Vector3 way = there.P - light.position();
                if (way.dot(there.N) > 0.0) continue;
                const auto at =
                    meet(there.scene.spheres.at(0), {light.position(), way.normalised()});
                ASSERT_TRUE(at) << seed;
                EXPECT_LT((at->location - there.P).magnitude(), 1e-10) << seed;
            }
        }
}

}  // namespace
}  // namespace ticker::tasks::maintick
