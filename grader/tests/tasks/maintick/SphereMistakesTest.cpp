#include <grader/tasks/maintick/Hits.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

using Answer = std::optional<double>;
constexpr Answer kMiss = std::nullopt;
constexpr Vector3 kForwards{0.0, 0.0, 1.0};

// The ball asked about has its centre at (0, 0, 5) and radius 2, the first one of the scene has
// radius 1. With roots by hand: from outside 3 and 7, from inside -1 and 3, from behind -6 and -2,
// and a discriminant of -20 past it.
const std::array<Ray, 4> kRays{Ray{{}, kForwards}, Ray{{0.0, 0.0, 4.0}, kForwards},
                               Ray{{0.0, 0.0, 9.0}, kForwards}, Ray{{3.0, 0.0, 0.0}, kForwards}};

raytracer::SceneDescription twoBalls(double radius = 2.0) {
    raytracer::SceneDescription scene;
    scene.spheres.push_back({{9.0, 9.0, 9.0}, 1.0, {}, nullptr});
    scene.spheres.push_back({{0.0, 0.0, 5.0}, radius, {}, nullptr});
    return scene;
}

void expectSame(const Answer& given, const Answer& wanted, std::size_t mistake, std::size_t ray) {
    ASSERT_EQ(given.has_value(), wanted.has_value()) << "mistake " << mistake << ", ray " << ray;
    if (!wanted) return;
    if (std::isnan(*wanted))
        EXPECT_TRUE(std::isnan(*given)) << "mistake " << mistake;
    else
        EXPECT_NEAR(*given, *wanted, 1e-9) << "mistake " << mistake << ", ray " << ray;
}

TEST(SphereMistakes, AnswerWhatTheirCodeWould) {
    const auto root = [](double a) { return std::sqrt(a); };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<std::array<Answer, 4>> wanted{
        {7.0, 3.0, kMiss, kMiss},                            // the far root
        {3.0, kMiss, kMiss, kMiss},                          // no far root
        {3.0, kMiss, kMiss, kMiss},                          // the smaller one, ahead
        {3.0, 1.0, kMiss, kMiss},                            // its size
        {3.0, -1.0, kMiss, kMiss},                           // the near one if the far one is ahead
        {3.0, 3.0, kMiss, kMiss},                            // the near one a little behind, lost,
        {3.0, 3.0, kMiss, kMiss},                            // taken with the far one,
        {3.0, 3.0, kMiss, kMiss},                            // or alone
        {3.0, 3.0, kMiss, kMiss},                            // the far one a little behind
        {3.0, -1.0, -6.0, kMiss},                            // the near one always
        {3.0, 1.0, 2.0, kMiss},                              // the smaller one's size always
        {3.0, 1.0, 6.0, kMiss},                              // the near one's size
        {3.0, -1.0, -2.0, kMiss},                            // the smaller one always
        {3.0, 3.0, -2.0, kMiss},                             // the far one behind
        {3.0, 3.0, kMiss, (10.0 - root(20.0)) / 2.0},        // |discriminant|
        {3.0, 3.0, kMiss, nan},                              // its root, even if negative
        {kMiss, (1.0 + root(13.0)) / 2.0, kMiss, kMiss},     // b without 2
        {(10.0 - root(8.0)) / 2.0, (2.0 + root(8.0)) / 2.0,  // c - r
         kMiss, kMiss},
        {5.0, 1.0, kMiss, kMiss},                             // c without a radius
        {kMiss, kMiss, kMiss, kMiss},                         // c + r * r
        {kMiss, 1.0, 2.0, kMiss},                             // -b
        {3.0, 3.0, 3.0, 3.0},                                 // without the origin
        {(10.0 - root(79.0)) / 2.0, (2.0 + root(7.0)) / 2.0,  // b * b - c
         kMiss, (10.0 - root(70.0)) / 2.0},
        {6.0, 6.0, kMiss, kMiss},      // not divided by 2
        {5.0, 1.0, kMiss, kMiss},      // no root at all,
        {5.0, 1.0, kMiss, kMiss},      // or none for the near side
        {13.0, 9.0, 4.0, kMiss},       // the discriminant itself, 16
        {9.0, 9.0, kMiss, kMiss},      // s squared
        {3.0, 7.0, kMiss, kMiss},      // the location's, from the world's origin
        {4.0, 2.0, kMiss, kMiss},      // the first radius
        {3.0, 3.0, kMiss, kMiss},      // nothing nearer than 1
        {3.0, 3.0, kMiss, kMiss},      // nothing behind the camera
        {3.0, 3.0, kMiss, kMiss},      // a limit of what is far,
        {3.0, 3.0, kMiss, kMiss},      // of what is near, for the near side,
        {3.0, 3.0, kMiss, kMiss},      // for what is taken,
        {3.0, 3.0, kMiss, kMiss},      // or for each side,
        {3.0, 3.0, kMiss, kMiss},      // and of the discriminant
        {kMiss, kMiss, kMiss, kMiss},  // no ray that leaves x as it is,
        {kMiss, kMiss, kMiss, kMiss},  // y,
        {3.0, 3.0, kMiss, kMiss},      // z,
        {kMiss, kMiss, kMiss, kMiss},  // x and y,
        {3.0, 3.0, kMiss, kMiss},      // x and z,
        {3.0, 3.0, kMiss, kMiss},      // or y and z
    };
    const auto mistakes = sphereMistakes();
    ASSERT_EQ(mistakes.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (std::size_t k = 0; k < kRays.size(); ++k)
            expectSame(mistakes[i].distance(twoBalls(), 1, kRays[k]), wanted[i][k], i, k);
}

TEST(SphereMistakes, TakeTheNearRootALittleBehindTheRay) {
    const auto mistakes = sphereMistakes();
    constexpr std::size_t kLost = 5;
    const auto asked = [&](std::size_t mistake, double z) {
        return mistakes[mistake].distance(twoBalls(), 1, {{0.0, 0.0, z}, kForwards});
    };
    expectSame(asked(kLost, 3.04), kMiss, kLost, 0);
    expectSame(asked(kLost, 3.06), 3.94, kLost, 1);
    expectSame(asked(kLost + 1, 3.04), -0.04, kLost + 1, 0);
    expectSame(asked(kLost + 1, 3.06), 3.94, kLost + 1, 1);
    expectSame(asked(kLost + 1, 7.04), -0.04, kLost + 1, 2);
    expectSame(asked(kLost + 1, 7.06), kMiss, kLost + 1, 3);
    expectSame(asked(kLost + 2, 3.04), -0.04, kLost + 2, 0);
    expectSame(asked(kLost + 2, 7.04), kMiss, kLost + 2, 1);
}

TEST(SphereMistakes, TakeTheFarRootALittleBehindTheRay) {
    const auto mistakes = sphereMistakes();
    constexpr std::size_t kFarBehind = 8;
    const auto asked = [&](double z) {
        return mistakes[kFarBehind].distance(twoBalls(), 1, {{0.0, 0.0, z}, kForwards});
    };
    expectSame(asked(3.04), 3.96, kFarBehind, 0);
    expectSame(asked(7.04), -0.04, kFarBehind, 1);
    expectSame(asked(7.06), kMiss, kFarBehind, 2);
}

TEST(SphereMistakes, TakeTheFarSideWhereThePointNearestToTheCentreIsBehind) {
    const auto mistakes = sphereMistakes();
    constexpr std::size_t kNearestPoint = 24;
    const auto asked = [&](std::size_t mistake, double z) {
        return mistakes[mistake].distance(twoBalls(), 1, {{0.0, 0.0, z}, kForwards});
    };
    expectSame(asked(kNearestPoint, 6.0), kMiss, kNearestPoint, 0);
    expectSame(asked(kNearestPoint + 1, 6.0), 1.0, kNearestPoint + 1, 1);
}

TEST(SphereMistakes, LeaveOutWhatTheirLimitsLeaveOut) {
    const auto mistakes = sphereMistakes();
    const std::size_t farLimit = mistakes.size() - 11;
    const auto asked = [&](std::size_t mistake, double z, double radius) {
        return mistakes[mistake].distance(twoBalls(radius), 1, {{0.0, 0.0, z}, kForwards});
    };
    expectSame(asked(farLimit, -996.5, 2.0), 999.5, farLimit, 0);
    expectSame(asked(farLimit, -998.5, 2.0), kMiss, farLimit, 1);
    expectSame(asked(farLimit + 1, 2.96, 2.0), 4.04, farLimit + 1, 0);
    expectSame(asked(farLimit + 1, 2.94, 2.0), 0.06, farLimit + 1, 1);
    expectSame(asked(farLimit + 2, 2.94, 2.0), 0.06, farLimit + 2, 0);
    expectSame(asked(farLimit + 2, 2.96, 2.0), kMiss, farLimit + 2, 1);
    expectSame(asked(farLimit + 2, 6.94, 2.0), 0.06, farLimit + 2, 2);
    expectSame(asked(farLimit + 3, 2.96, 2.0), 4.04, farLimit + 3, 0);
    expectSame(asked(farLimit + 3, 6.94, 2.0), 0.06, farLimit + 3, 1);
    expectSame(asked(farLimit + 3, 6.96, 2.0), kMiss, farLimit + 3, 2);
    expectSame(asked(farLimit + 4, 0.0, 0.032), 4.968, farLimit + 4, 0);
    expectSame(asked(farLimit + 4, 0.0, 0.0316), kMiss, farLimit + 4, 1);
}

}  // namespace
}  // namespace ticker::tasks::maintick
