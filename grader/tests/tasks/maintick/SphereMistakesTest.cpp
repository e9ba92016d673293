#include <grader/tests/tasks/maintick/MistakeRows.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

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

const std::vector<MistakeRow<4>>& sphereRows() {
    const auto root = [](double a) { return std::sqrt(a); };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    static const std::vector<MistakeRow<4>> kRows{
        {"the far root", {7.0, 3.0, kMiss, kMiss}},
        {"the near root alone", {3.0, kMiss, kMiss, kMiss}},
        {"the smaller root if it is ahead", {3.0, kMiss, kMiss, kMiss}},
        {"the smaller root's size if the far one is ahead", {3.0, 1.0, kMiss, kMiss}},
        {"the near root if the far one is ahead", {3.0, -1.0, kMiss, kMiss}},
        {"a near root a little behind, then lost", {3.0, 3.0, kMiss, kMiss}},
        {"a near or far root a little behind", {3.0, 3.0, kMiss, kMiss}},
        {"a near root a little behind", {3.0, 3.0, kMiss, kMiss}},
        {"a far root a little behind", {3.0, 3.0, kMiss, kMiss}},
        {"the near root always", {3.0, -1.0, -6.0, kMiss}},
        {"the smaller root's size always", {3.0, 1.0, 2.0, kMiss}},
        {"the near root's size always", {3.0, 1.0, 6.0, kMiss}},
        {"the smaller root always", {3.0, -1.0, -2.0, kMiss}},
        {"the far root unless the near one is ahead", {3.0, 3.0, -2.0, kMiss}},
        {"the discriminant's size", {3.0, 3.0, kMiss, (10.0 - root(20.0)) / 2.0}},
        {"the root of a negative discriminant", {3.0, 3.0, kMiss, nan}},
        {"b without 2", {kMiss, (1.0 + root(13.0)) / 2.0, kMiss, kMiss}},
        {"c - r", {(10.0 - root(8.0)) / 2.0, (2.0 + root(8.0)) / 2.0, kMiss, kMiss}},
        {"c without a radius", {5.0, 1.0, kMiss, kMiss}},
        {"c + r * r", {kMiss, kMiss, kMiss, kMiss}},
        {"-b", {kMiss, 1.0, 2.0, kMiss}},
        {"without the origin", {3.0, 3.0, 3.0, 3.0}},
        {"b * b - c",
         {(10.0 - root(79.0)) / 2.0, (2.0 + root(7.0)) / 2.0, kMiss, (10.0 - root(70.0)) / 2.0}},
        {"not divided by 2", {6.0, 6.0, kMiss, kMiss}},
        {"no root at all", {5.0, 1.0, kMiss, kMiss}},
        {"no root for the near side", {5.0, 1.0, kMiss, kMiss}},
        {"the discriminant itself, 16", {13.0, 9.0, 4.0, kMiss}},
        {"s squared", {9.0, 9.0, kMiss, kMiss}},
        {"the location's distance from the world's origin", {3.0, 7.0, kMiss, kMiss}},
        {"the first sphere's radius", {4.0, 2.0, kMiss, kMiss}},
        {"nothing nearer than 1", {3.0, 3.0, kMiss, kMiss}},
        {"nothing behind the camera", {3.0, 3.0, kMiss, kMiss}},
        {"a limit of what is far", {3.0, 3.0, kMiss, kMiss}},
        {"a limit for the near side", {3.0, 3.0, kMiss, kMiss}},
        {"a limit for what is taken", {3.0, 3.0, kMiss, kMiss}},
        {"a limit for each side", {3.0, 3.0, kMiss, kMiss}},
        {"a limit of the discriminant", {3.0, 3.0, kMiss, kMiss}},
        {"no ray that leaves x as it is", {kMiss, kMiss, kMiss, kMiss}},
        {"no ray that leaves y as it is", {kMiss, kMiss, kMiss, kMiss}},
        {"no ray that leaves z as it is", {3.0, 3.0, kMiss, kMiss}},
        {"no ray that leaves x and y as they are", {kMiss, kMiss, kMiss, kMiss}},
        {"no ray that leaves x and z as they are", {3.0, 3.0, kMiss, kMiss}},
        {"no ray that leaves y and z as they are", {3.0, 3.0, kMiss, kMiss}},
    };
    return kRows;
}

/// Expects this answer along the z axis, from this z on.
void expectAlongZ(std::string_view mistake, double z, const Distance& wanted, double radius = 2.0) {
    SCOPED_TRACE(testing::Message() << mistake << ", from " << z);
    const HitMistake& asked = mistakeNamed(mistake, sphereRows(), sphereMistakes());
    expectDistance(asked.distance(twoBalls(radius), 1, {{0.0, 0.0, z}, kForwards}), wanted);
}

TEST(SphereMistakes, AnswerWhatTheirCodeWould) {
    const auto mistakes = sphereMistakes();
    ASSERT_EQ(mistakes.size(), sphereRows().size());
    for (std::size_t i = 0; i < mistakes.size(); ++i)
        for (std::size_t k = 0; k < kRays.size(); ++k) {
            const MistakeRow<4>& row = sphereRows()[i];
            SCOPED_TRACE(testing::Message() << row.name << ", ray " << k);
            expectDistance(mistakes[i].distance(twoBalls(), 1, kRays[k]), row.answers[k]);
        }
}

TEST(SphereMistakes, TakeTheNearRootALittleBehindTheRay) {
    const char* const lost = "a near root a little behind, then lost";
    expectAlongZ(lost, 3.04, kMiss);
    expectAlongZ(lost, 3.06, 3.94);
    const char* const both = "a near or far root a little behind";
    expectAlongZ(both, 3.04, -0.04);
    expectAlongZ(both, 3.06, 3.94);
    expectAlongZ(both, 7.04, -0.04);
    expectAlongZ(both, 7.06, kMiss);
    const char* const nearAlone = "a near root a little behind";
    expectAlongZ(nearAlone, 3.04, -0.04);
    expectAlongZ(nearAlone, 7.04, kMiss);
}

TEST(SphereMistakes, TakeTheFarRootALittleBehindTheRay) {
    const char* const farAlone = "a far root a little behind";
    expectAlongZ(farAlone, 3.04, 3.96);
    expectAlongZ(farAlone, 7.04, -0.04);
    expectAlongZ(farAlone, 7.06, kMiss);
}

TEST(SphereMistakes, TakeTheFarSideWhereThePointNearestToTheCentreIsBehind) {
    expectAlongZ("no root at all", 6.0, kMiss);
    expectAlongZ("no root for the near side", 6.0, 1.0);
}

TEST(SphereMistakes, LeaveOutWhatTheirLimitsLeaveOut) {
    const char* const ofFar = "a limit of what is far";
    expectAlongZ(ofFar, -996.5, 999.5);
    expectAlongZ(ofFar, -998.5, kMiss);
    const char* const ofNearSide = "a limit for the near side";
    expectAlongZ(ofNearSide, 2.96, 4.04);
    expectAlongZ(ofNearSide, 2.94, 0.06);
    const char* const ofTaken = "a limit for what is taken";
    expectAlongZ(ofTaken, 2.94, 0.06);
    expectAlongZ(ofTaken, 2.96, kMiss);
    expectAlongZ(ofTaken, 6.94, 0.06);
    const char* const ofEachSide = "a limit for each side";
    expectAlongZ(ofEachSide, 2.96, 4.04);
    expectAlongZ(ofEachSide, 6.94, 0.06);
    expectAlongZ(ofEachSide, 6.96, kMiss);
    const char* const ofDiscriminant = "a limit of the discriminant";
    expectAlongZ(ofDiscriminant, 0.0, 4.968, 0.032);
    expectAlongZ(ofDiscriminant, 0.0, kMiss, 0.0316);
}

}  // namespace
}  // namespace ticker::tasks::maintick
