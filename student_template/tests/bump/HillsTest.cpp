// A map that rises and falls along both axes at once.
#include <bump/BumpMapping.h>
#include <bump/BumpSurvey.h>
#include <raytracer/geometry/HeightMap.h>
#include <raytracer/math/Vector3.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace raytracer::tests::bump {
namespace {

/// Hills that wave along both axes; the columns are periodic.
double hillAt(double u, double v) {
    const double turn = 2.0 * std::numbers::pi;
    return 2.5 + 1.2 * std::sin(turn * 3.0 * u + 0.4) * std::cos(turn * 1.5 * v) +
           1.2 * std::cos(turn * 2.0 * u - turn * 2.0 * v + 1.0);
}

HeightMap hills() {
    constexpr int kWidth = 720;
    constexpr int kHeight = 360;
    std::vector<double> heights;
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column)
            heights.push_back(hillAt((column + 0.5) / kWidth, (row + 0.5) / kHeight));
    return {kWidth, kHeight, std::move(heights)};
}

/// How well tilts follow slopes, from -1 to 1, weighted by the size of both: 1 if all normals lean
/// away from the rising side, as on raised bumps, -1 if all lean towards it.
class Agreement {
public:
    void add(double tilt, double slope) {
        sum_ -= tilt * slope;
        all_ += std::abs(tilt * slope);
    }
    [[nodiscard]] double share() const { return all_ > 0.0 ? sum_ / all_ : 0.0; }

private:
    double sum_ = 0.0;
    double all_ = 0.0;
};

TEST_F(BumpMapping, TheTiltFollowsHillsAndValleysAlongBothAxes) {
    if (!couldSurvey() || survey()->points().empty()) return;
    std::vector<Vector3> directions;
    for (const SurveyPoint& point : survey()->points())
        directions.push_back(point.direction);
    const std::vector<Vector3> tilts = tiltsBeyondFlat(hills(), directions);
    std::array<Agreement, 2> agreements;
    constexpr double kLittle = 1e-3;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        const SurveyPoint& point = survey()->points()[i];
        const double u = point.u.place;
        const double v = point.v.place;
        if (!std::isfinite(tilts[i].magnitude()) || v < 0.03 || v > 0.97) continue;
        agreements[0].add(tilts[i].dot(point.u.along),
                          hillAt(u + kLittle, v) - hillAt(u - kLittle, v));
        agreements[1].add(tilts[i].dot(point.v.along),
                          hillAt(u, v + kLittle) - hillAt(u, v - kLittle));
    }
    constexpr double kEnough = 0.9;
    for (const auto& [axis, share] :
         {std::pair{"u", agreements[0].share()}, {"v", agreements[1].share()}}) {
        if (share >= kEnough) continue;
        complain("a map of hills and valleys", "tilts that follow the slopes of this very place",
                 std::string("along ") + axis +
                     (share < 0.0 ? " they lean the other way"
                                  : " " + percent(share) + " of the tilt does"),
                 share < -kEnough
                     ? std::string("the bumps are inverted along ") + axis
                     : "each difference is taken between neighbours along one axis only, at this "
                       "row and this column; falling slopes tilt the other way than rising ones",
                 "Option 1: What to do, step 3");
    }
}

}  // namespace
}  // namespace raytracer::tests::bump
