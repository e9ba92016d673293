#include <grader/tests/tasks/maintick/MistakeRows.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

/// The plane asked about is z = 5 with a normal towards the origin; the first one of the scene has
/// another point, and a normal the other way.
Distance askedOfPlane(const HitMistake& mistake, const Ray& ray) {
    raytracer::SceneDescription scene;
    scene.planes.push_back({{0.0, 0.0, 8.0}, {0.0, 0.0, 3.0}, {}});
    scene.planes.push_back({{7.0, 0.0, 5.0}, {0.0, 0.0, -2.0}, {}});
    return mistake.distance(scene, 1, ray);
}

// From the front s = 5 with (Q - O).N = -4 and D.N = -0.8, from the back 5 with 4 and 0.8, and away
// from the plane -4 with 4 and -1.
const std::array<Ray, 3> kPlaneRays{Ray{{0.0, 0.0, 1.0}, {0.0, 0.6, 0.8}},
                                    Ray{{0.0, 0.0, 9.0}, {0.0, 0.6, -0.8}},
                                    Ray{{0.0, 0.0, 9.0}, {0.0, 0.0, 1.0}}};

const std::vector<MistakeRow<3>>& planeRows() {
    static const std::vector<MistakeRow<3>> kRows{
        {"-s", {kMiss, kMiss, 4.0}},
        {"without the origin", {6.25, kMiss, 5.0}},
        {"the origin added", {7.5, kMiss, 14.0}},
        {"without the point", {kMiss, 11.25, kMiss}},
        {"not divided", {kMiss, 4.0, 4.0}},
        {"upside down", {0.2, 0.2, kMiss}},
        {"multiplied", {3.2, 3.2, kMiss}},
        {"behind as well", {5.0, 5.0, -4.0}},
        {"|s|", {5.0, 5.0, 4.0}},
        {"behind alone", {kMiss, kMiss, -4.0}},
        {"from the front alone", {5.0, kMiss, kMiss}},
        {"from the back alone", {kMiss, 5.0, kMiss}},
        {"from the front, behind as well", {5.0, kMiss, -4.0}},
        {"|D.N|", {kMiss, 5.0, 4.0}},
        {"the height above the plane", {4.0, 4.0, kMiss}},
        {"Q.N of the first plane", {kMiss, 21.25, kMiss}},
        {"Q of the first plane", {8.75, 1.25, kMiss}},
        {"nothing behind the camera", {5.0, 5.0, kMiss}},
        {"a limit of what is far", {5.0, 5.0, kMiss}},
        {"a limit of the slope", {5.0, 5.0, kMiss}},
        {"a limit of what is near", {5.0, 5.0, kMiss}},
        {"a smaller limit of what is near", {5.0, 5.0, kMiss}},
        {"a limit of the height", {5.0, 5.0, kMiss}},
        {"a smaller limit of the height", {5.0, 5.0, kMiss}},
        {"nothing far from the point", {kMiss, kMiss, kMiss}},
        {"no ray that leaves x as it is", {kMiss, kMiss, kMiss}},
        {"no ray that leaves y as it is", {5.0, 5.0, kMiss}},
        {"no ray that leaves z as it is", {5.0, 5.0, kMiss}},
        {"no ray that leaves x and y as they are", {5.0, 5.0, kMiss}},
        {"no ray that leaves x and z as they are", {5.0, 5.0, kMiss}},
        {"no ray that leaves y and z as they are", {5.0, 5.0, kMiss}},
        {"along x alone", {kMiss, kMiss, kMiss}},
        {"along y alone", {kMiss, kMiss, kMiss}},
        {"along z alone", {5.0, 5.0, kMiss}},
        {"along the nearest axis", {5.0, 5.0, kMiss}},
    };
    return kRows;
}

const HitMistake& planeMistake(std::string_view name) {
    return mistakeNamed(name, planeRows(), planeMistakes());
}

TEST(PlaneMistakes, AnswerWhatTheirCodeWould) {
    const auto mistakes = planeMistakes();
    ASSERT_EQ(mistakes.size(), planeRows().size());
    for (std::size_t i = 0; i < mistakes.size(); ++i)
        for (std::size_t k = 0; k < kPlaneRays.size(); ++k) {
            const MistakeRow<3>& row = planeRows()[i];
            SCOPED_TRACE(testing::Message() << row.name << ", ray " << k);
            expectDistance(askedOfPlane(mistakes[i], kPlaneRays[k]), row.answers[k]);
        }
}

void expectMet(std::string_view mistake, const Ray& ray, const Distance& wanted) {
    SCOPED_TRACE(mistake);
    expectDistance(askedOfPlane(planeMistake(mistake), ray), wanted);
}

TEST(PlaneMistakes, LeaveOutWhatTheirLimitsLeaveOut) {
    const auto from = [](double z) { return Ray{{0.0, 0.0, z}, {0.0, 0.0, 1.0}}; };
    const auto sloping = [](double slope) {
        return Ray{{}, {0.0, std::sqrt(1.0 - slope * slope), slope}};
    };
    expectMet("a limit of what is far", from(-994.5), 999.5);
    expectMet("a limit of what is far", from(-995.5), kMiss);
    expectMet("a limit of the slope", sloping(0.011), 5.0 / 0.011);
    expectMet("a limit of the slope", sloping(0.009), kMiss);
    expectMet("a limit of what is near", from(4.94), 0.06);
    expectMet("a limit of what is near", from(4.96), kMiss);
    expectMet("a smaller limit of what is near", from(4.98), 0.02);
    expectMet("a smaller limit of what is near", from(4.995), kMiss);
    expectMet("a limit of the height", from(4.97), 0.03);
    expectMet("a limit of the height", from(4.99), kMiss);
    expectMet("a smaller limit of the height", from(4.9989), 0.0011);
    expectMet("a smaller limit of the height", from(4.9991), kMiss);
}

TEST(PlaneMistakes, EndAPlaneFourUnitsFromItsPoint) {
    const char* const rim = "nothing far from the point";
    const auto aside = [](double x) { return Ray{{7.0 + x, 0.0, 1.0}, {0.0, 0.0, 1.0}}; };
    expectMet(rim, aside(-3.9), 4.0);
    expectMet(rim, aside(4.1), kMiss);
}

TEST(PlaneMistakes, TakeALeaningPlaneForOneOfAnAxis) {
    const Ray ray{{1.0, 1.0, 1.0}, {0.6, 0.64, 0.48}};
    raytracer::SceneDescription scene;
    for (const Vector3& normal :
         {Vector3{3.0, -0.1, 0.1}, Vector3{0.1, -3.0, 0.1}, Vector3{0.1, 0.1, -3.0}})
        scene.planes.push_back({{2.2, 2.6, 2.44}, normal, {}});
    struct Axis {
        std::string_view mistake;
        int leaning;  ///< the plane whose normal is nearest to it
        double distance;
    };
    for (const Axis& axis : {Axis{"along x alone", 0, 2.0}, Axis{"along y alone", 1, 2.5},
                             Axis{"along z alone", 2, 3.0}}) {
        expectDistance(planeMistake(axis.mistake).distance(scene, 0, ray), axis.distance);
        expectDistance(planeMistake("along the nearest axis").distance(scene, axis.leaning, ray),
                       axis.distance);
    }
}

}  // namespace
}  // namespace ticker::tasks::maintick
