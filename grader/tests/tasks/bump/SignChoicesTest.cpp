// The handout's form with a plus before both cross products, in all sign choices of P_u, P_v, B_u
// and B_v.
#include <grader/lab/selftest/FunctionExaminee.h>
#include <grader/tasks/bump/JudgeBump.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace ticker::tests {
namespace {

using raytracer::Vector3;
using selftest::Point;

/// +1: P_u to the right, P_v downwards, slopes as neighbour minus this texel.
struct Signs {
    double pu;
    double pv;
    double bu;
    double bv;
};

Vector3 asPrinted(const Signs& signs, const Point& point) {
    const Vector3 n = (point.position - point.centre).normalised();
    const double longitude = std::atan2(n.x, -n.z);
    const double polar = std::acos(std::clamp(n.y, -1.0, 1.0));
    const Vector3 pu = signs.pu * Vector3{std::cos(longitude), 0.0, std::sin(longitude)};
    const Vector3 pv = signs.pv * Vector3{std::sin(longitude) * std::cos(polar), -std::sin(polar),
                                          -std::cos(longitude) * std::cos(polar)};
    const int width = point.map.width();
    const int height = point.map.height();
    const double u = longitude / (2.0 * std::numbers::pi) + 0.5;
    const int column = std::min(static_cast<int>(u * width), width - 1);
    const int row = std::min(static_cast<int>(polar / std::numbers::pi * height), height - 1);
    const double here = point.map.at(column, row);
    const double bu = signs.bu * (point.map.at((column + 1) % width, row) - here);
    const double bv = signs.bv * (point.map.at(column, std::min(row + 1, height - 1)) - here);
    return (n + bu * n.cross(pv) + bv * n.cross(pu)).normalised();
}

/// The expected result: with P_u x P_v = h n the printed form is n - h B_u P_u + h B_v P_v, and a
/// raised bump needs a minus before both true slopes.
std::string expected(const Signs& signs) {
    const double h = signs.pu * signs.pv;  // right x down = +n in this left-handed world
    const bool uRight = h * signs.bu * signs.pu > 0.0;
    const bool vRight = h * signs.bv * signs.pv < 0.0;
    if (uRight && vRight) return "";
    if (uRight) return "bump.inverted-v";
    return vRight ? "bump.inverted-u" : "bump.inverted";
}

TEST(PlusBeforeBothCrossProducts, IsRightInFourSignChoicesHalfRightInEightAndInvertedInFour) {
    std::map<std::string, int> seen;
    for (int choice = 0; choice < 16; ++choice) {
        const auto sign = [choice](int bit) { return ((choice >> bit) & 1) != 0 ? -1.0 : 1.0; };
        const Signs signs{sign(0), sign(1), sign(2), sign(3)};
        selftest::FunctionExaminee examinee(
            [&](const Point& point) { return asPrinted(signs, point); });
        const TaskJudgement judgement = tasks::judgeBump(examinee, 7);
        const std::string got = judgement.findings.empty() ? "" : judgement.findings.front().id;
        EXPECT_EQ(got, expected(signs)) << "choice " << choice << ": " << judgement.reason;
        EXPECT_EQ(judgement.state, got.empty() ? TaskState::passed : TaskState::failed);
        ++seen[got];
    }
    EXPECT_EQ(seen[""], 4);
    EXPECT_EQ(seen["bump.inverted-u"], 4);
    EXPECT_EQ(seen["bump.inverted-v"], 4);
    EXPECT_EQ(seen["bump.inverted"], 4);
}

}  // namespace
}  // namespace ticker::tests
