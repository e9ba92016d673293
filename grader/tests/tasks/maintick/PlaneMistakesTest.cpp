#include <grader/tasks/maintick/Hits.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

constexpr Distance kPasses = std::nullopt;

/// The plane asked about is z = 5 with a normal towards the origin; the first one of the scene has
/// another point, and a normal the other way.
Distance askedOfPlane(const HitMistake& mistake, const Ray& ray) {
    raytracer::SceneDescription scene;
    scene.planes.push_back({{0.0, 0.0, 8.0}, {0.0, 0.0, 3.0}, {}});
    scene.planes.push_back({{7.0, 0.0, 5.0}, {0.0, 0.0, -2.0}, {}});
    return mistake.distance(scene, 1, ray);
}

void expectDistance(const Distance& given, const Distance& wanted) {
    ASSERT_EQ(given.has_value(), wanted.has_value());
    if (wanted) {
        EXPECT_NEAR(*given, *wanted, 1e-9);
    }
}

// From the front s = 5 with (Q - O).N = -4 and D.N = -0.8, from the back 5 with 4 and 0.8, and away
// from the plane -4 with 4 and -1.
TEST(PlaneMistakes, AnswerWhatTheirCodeWould) {
    const std::array<Ray, 3> rays{Ray{{0.0, 0.0, 1.0}, {0.0, 0.6, 0.8}},
                                  Ray{{0.0, 0.0, 9.0}, {0.0, 0.6, -0.8}},
                                  Ray{{0.0, 0.0, 9.0}, {0.0, 0.0, 1.0}}};
    const std::vector<std::array<Distance, 3>> wanted{
        {kPasses, kPasses, 4.0},      // -s
        {6.25, kPasses, 5.0},         // without the origin
        {7.5, kPasses, 14.0},         // the origin added
        {kPasses, 11.25, kPasses},    // without the point
        {kPasses, 4.0, 4.0},          // not divided
        {0.2, 0.2, kPasses},          // upside down
        {3.2, 3.2, kPasses},          // multiplied
        {5.0, 5.0, -4.0},             // behind as well
        {5.0, 5.0, 4.0},              // |s|
        {kPasses, kPasses, -4.0},     // behind alone
        {5.0, kPasses, kPasses},      // from the front alone
        {kPasses, 5.0, kPasses},      // from the back alone
        {5.0, kPasses, -4.0},         // from the front, behind as well
        {kPasses, 5.0, 4.0},          // |D.N|
        {4.0, 4.0, kPasses},          // the height above the plane
        {kPasses, 21.25, kPasses},    // Q.N of the first plane,
        {8.75, 1.25, kPasses},        // or its point alone
        {5.0, 5.0, kPasses},          // nothing behind the camera
        {5.0, 5.0, kPasses},          // a limit of what is far,
        {5.0, 5.0, kPasses},          // of the slope,
        {5.0, 5.0, kPasses},          // of what is near,
        {5.0, 5.0, kPasses},          // or nearer,
        {5.0, 5.0, kPasses},          // and of the height,
        {5.0, 5.0, kPasses},          // and of a small one
        {kPasses, kPasses, kPasses},  // nothing far from the point
        {kPasses, kPasses, kPasses},  // no ray that leaves x as it is,
        {5.0, 5.0, kPasses},          // y,
        {5.0, 5.0, kPasses},          // z,
        {5.0, 5.0, kPasses},          // x and y,
        {5.0, 5.0, kPasses},          // x and z,
        {5.0, 5.0, kPasses},          // or y and z
        {kPasses, kPasses, kPasses},  // along x alone,
        {kPasses, kPasses, kPasses},  // along y,
        {5.0, 5.0, kPasses},          // along z,
        {5.0, 5.0, kPasses},          // or along the axis that is nearest
    };
    const auto mistakes = planeMistakes();
    ASSERT_EQ(mistakes.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (std::size_t k = 0; k < rays.size(); ++k) {
            SCOPED_TRACE(testing::Message() << "mistake " << i << ", ray " << k);
            expectDistance(askedOfPlane(mistakes[i], rays[k]), wanted[i][k]);
        }
}

TEST(PlaneMistakes, LeaveOutWhatTheirLimitsLeaveOut) {
    const auto mistakes = planeMistakes();
    const std::size_t last = mistakes.size() - 15;
    const auto from = [](double z) { return Ray{{0.0, 0.0, z}, {0.0, 0.0, 1.0}}; };
    const auto sloping = [](double slope) {
        return Ray{{}, {0.0, std::sqrt(1.0 - slope * slope), slope}};
    };
    expectDistance(askedOfPlane(mistakes[last - 2], from(-994.5)), 999.5);
    expectDistance(askedOfPlane(mistakes[last - 2], from(-995.5)), kPasses);
    expectDistance(askedOfPlane(mistakes[last - 1], sloping(0.011)), 5.0 / 0.011);
    expectDistance(askedOfPlane(mistakes[last - 1], sloping(0.009)), kPasses);
    expectDistance(askedOfPlane(mistakes[last], from(4.94)), 0.06);
    expectDistance(askedOfPlane(mistakes[last], from(4.96)), kPasses);
    expectDistance(askedOfPlane(mistakes[last + 1], from(4.98)), 0.02);
    expectDistance(askedOfPlane(mistakes[last + 1], from(4.995)), kPasses);
    expectDistance(askedOfPlane(mistakes[last + 2], from(4.97)), 0.03);
    expectDistance(askedOfPlane(mistakes[last + 2], from(4.99)), kPasses);
    expectDistance(askedOfPlane(mistakes[last + 3], from(4.9989)), 0.0011);
    expectDistance(askedOfPlane(mistakes[last + 3], from(4.9991)), kPasses);
}

TEST(PlaneMistakes, EndAPlaneFourUnitsFromItsPoint) {
    const HitMistake& rim = planeMistakes()[planeMistakes().size() - 11];
    const auto aside = [](double x) { return Ray{{7.0 + x, 0.0, 1.0}, {0.0, 0.0, 1.0}}; };
    expectDistance(askedOfPlane(rim, aside(-3.9)), 4.0);
    expectDistance(askedOfPlane(rim, aside(4.1)), kPasses);
}

TEST(PlaneMistakes, TakeALeaningPlaneForOneOfAnAxis) {
    const auto mistakes = planeMistakes();
    const std::size_t x = mistakes.size() - 4;
    const Ray ray{{1.0, 1.0, 1.0}, {0.6, 0.64, 0.48}};
    raytracer::SceneDescription scene;
    for (const Vector3& normal :
         {Vector3{3.0, -0.1, 0.1}, Vector3{0.1, -3.0, 0.1}, Vector3{0.1, 0.1, -3.0}})
        scene.planes.push_back({{2.2, 2.6, 2.44}, normal, {}});
    const std::array<double, 3> along{2.0, 2.5, 3.0};
    for (std::size_t i = 0; i < along.size(); ++i) {
        expectDistance(mistakes[x + i].distance(scene, 0, ray), along[i]);
        expectDistance(mistakes[x + 3].distance(scene, static_cast<int>(i), ray), along[i]);
    }
}

}  // namespace
}  // namespace ticker::tasks::maintick
