// Public tests of task T1, BumpySphere::getNormalAt.
#include <questions/BumpQuestions.h>
#include <raytracer/base/Unfinished.h>
#include <raytracer/geometry/BumpySphere.h>
#include <support/BumpSurvey.h>
#include <support/Complaint.h>
#include <support/Draws.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raytracer::tests {
namespace {

constexpr double kGentle = 0.3;

void complain(const std::string& asked, const std::string& expected, const std::string& got,
              const std::string& cause, const std::string& section) {
    ADD_FAILURE() << Complaint{"T1", asked, expected, got, cause, section};
}

std::string words(const Vector3& v) {
    return "(" + inWords(v.x) + ", " + inWords(v.y) + ", " + inWords(v.z) + ")";
}

/// Random heights: whatever goes wrong somewhere goes wrong on such a map.
std::shared_ptr<const HeightMap> roughMap(int width, int height) {
    Draws draws{static_cast<std::uint64_t>(width * 1000 + height)};
    std::vector<double> heights;
    for (int i = 0; i < width * height; ++i)
        heights.push_back(draws.between(0.0, kBumpFactor));
    return std::make_shared<const HeightMap>(width, height, std::move(heights));
}

/// Ordinary points, and those where an angle or a coordinate is exactly 0.
std::vector<Vector3> telltaleDirections() {
    std::vector<Vector3> directions{{0, 1, 0},  {0, -1, 0}, {1, 0, 0},
                                    {-1, 0, 0}, {0, 0, 1},  {0, 0, -1}};
    Draws draws{11};
    for (int i = 0; i < 400; ++i)
        directions.push_back(draws.direction());
    return directions;
}

class BumpMapping : public ::testing::Test {
protected:
    void SetUp() override {
        try {
            const BumpySphere sphere{{0, 0, 3}, 1.0, {}, roughMap(16, 8)};
            static_cast<void>(sphere.getNormalAt({0.36, 0.48, 2.2}));
        } catch (const std::exception&) {
            // A test says so.
        }
        if (isUnfinished("T1"))
            GTEST_SKIP() << "T1 is not attempted: the line unfinished(\"T1\", ...) still stands";
    }

    /// What the solution does on gentle slopes; empty where it throws, which a test of its own
    /// says.
    static const std::optional<BumpSurvey>& survey() {
        static const std::optional<BumpSurvey> found = surveyOn(kGentle);
        return found;
    }

    static std::optional<BumpSurvey> surveyOn(double rise) {
        try {
            return BumpSurvey{rise};
        } catch (const std::exception&) {
            return std::nullopt;
        }
    }

    static bool couldSurvey() {
        if (!survey())
            complain("normals on maps of 1500 x 90 and 90 x 1500 texels", "an answer everywhere",
                     "an error that your code threw",
                     "see the test that answers come at every point of maps of any size",
                     "Option 1: What to do, step 1");
        return survey().has_value();
    }
};

TEST_F(BumpMapping, AnswersAtEveryPointOfMapsOfAnySize) {
    const Vector3 centre{0.4, -0.2, 3.5};
    for (const auto& [width, height] : {std::pair{4, 4}, {7, 5}, {97, 41}, {41, 97}}) {
        const std::string map =
            "a map of " + std::to_string(width) + " x " + std::to_string(height) + " texels";
        const BumpySphere sphere{centre, 0.7, {}, roughMap(width, height)};
        for (const Vector3& direction : telltaleDirections()) {
            const std::string asked =
                "the point " + words(direction) + " * radius + centre, " + map;
            try {
                const Vector3 normal = sphere.getNormalAt(centre + direction * 0.7);
                if (std::isfinite(normal.x + normal.y + normal.z)) continue;
                complain(asked, "a normal of numbers", words(normal),
                         "a division by zero, or acos of something beyond 1: rounding makes that "
                         "happen at a pole or straight ahead",
                         "Option 1: What to do, step 1");
            } catch (const std::exception& error) {
                complain(asked, "a normal", "the error: " + std::string(error.what()),
                         "columns go from 0 to width() - 1 and rows from 0 to height() - 1; the "
                         "neighbour of the last one needs care",
                         "Option 1: What to do, steps 1 and 3");
            }
            return;
        }
    }
}

TEST_F(BumpMapping, GivesNormalsOfUnitLength) {
    const BumpySphere sphere{{0.4, -0.2, 3.5}, 0.7, {}, roughMap(97, 41)};
    for (const Vector3& direction : telltaleDirections()) {
        Vector3 normal;
        try {
            normal = sphere.getNormalAt(sphere.centre() + direction * 0.7);
        } catch (const std::exception&) {
            continue;
        }
        const double length = normal.magnitude();
        if (std::abs(length - 1.0) < 1e-4 || !std::isfinite(length)) continue;
        complain("the point " + words(direction) + " * radius + centre", "length 1",
                 "length " + inWords(length), "normalise the sum at the end",
                 "Option 1: What to do, step 4");
        return;
    }
}

TEST_F(BumpMapping, KeepsTheSmoothNormalWhereTheMapIsFlat) {
    if (!couldSurvey()) return;
    const double tilt = survey()->strengthOnFlat();
    if (tilt < 0.05) return;
    complain("a map of one height", "the smooth normal", "a tilt of " + inWords(tilt) + " radians",
             "take differences of heights, not heights, and make sure that the smooth normal is "
             "the one from the centre to the point",
             "Option 1: What to do, step 3");
}

TEST_F(BumpMapping, TiltsTheNormalWhereTheMapSlopes) {
    if (!couldSurvey()) return;
    constexpr double kSomething = 1e-6;
    for (const bool u : {true, false}) {
        const double strength = u ? survey()->strengthU() : survey()->strengthV();
        if (strength > kSomething) continue;
        const std::string axis = u ? "u" : "v";
        complain("a map that rises evenly along " + axis + ", by " + inWords(kGentle) +
                     " over 1500 texels",
                 "normals that are tilted", "a tilt of " + inWords(strength) + " radians",
                 "B_" + axis + " is always 0 (whole numbers in place of double?) or never added",
                 "Option 1: What to do, steps 3 and 4");
    }
}

/// How the tilts at the surveyed points lie to the direction in which the map rises.
struct Leaning {
    double back = 0.0;    // away from what is higher: raised
    double into = 0.0;    // towards it: lowered
    double across = 0.0;  // along the other axis
};

Leaning leaningOf(const BumpSurvey& survey, AxisAtPoint SurveyPoint::*axis) {
    Leaning leaning;
    for (const SurveyPoint& point : survey.points()) {
        const AxisAtPoint& at = point.*axis;
        const double cosine = at.tilt.normalised().dot(at.along);
        // 25 degrees: tangents of the texel instead of the point turn an honest tilt by a few.
        if (cosine < -0.906) leaning.back += 1.0;
        if (cosine > 0.906) leaning.into += 1.0;
        if (std::abs(cosine) < 0.423) leaning.across += 1.0;
    }
    const double count = survey.asked();
    return {leaning.back / count, leaning.into / count, leaning.across / count};
}

std::string causeOf(const Leaning& leaning, const std::string& axis) {
    constexpr double kMost = 0.7;
    if (leaning.into > kMost)
        return "the bumps are inverted along " + axis +
               ": one sign is wrong, in the difference B_" + axis +
               ", in the tangent, or between the terms of Equation (1)";
    if (leaning.across > kMost)
        return "a slope along " + axis +
               " tilts along the other axis: B_u and B_v, the two tangents, or column and row are "
               "exchanged";
    return "the tilt turns from place to place: the tangents must be those of this very point, of "
           "the same parametrisation as u and v";
}

void expectLeaningBack(const BumpSurvey& survey, AxisAtPoint SurveyPoint::*axis,
                       const std::string& name) {
    const Leaning leaning = leaningOf(survey, axis);
    constexpr double kEnough = 0.85;  // the map's edges and its poles are lost
    if (leaning.back >= kEnough) return;
    complain("a map that rises evenly along " + name,
             "normals that lean back from where it is higher, as a raised bump's do",
             percent(leaning.back) + " of the points lean back, " + percent(leaning.into) +
                 " lean forward, " + percent(leaning.across) + " lean sideways",
             causeOf(leaning, name), "Option 1: The sign trap; What to do, step 3");
}

TEST_F(BumpMapping, LeansBackFromWhatIsHigherAlongU) {
    if (couldSurvey()) expectLeaningBack(*survey(), &SurveyPoint::u, "u");
}

TEST_F(BumpMapping, LeansBackFromWhatIsHigherAlongV) {
    if (couldSurvey()) expectLeaningBack(*survey(), &SurveyPoint::v, "v");
}

TEST_F(BumpMapping, LaysTheMapOnceRoundTheSphere) {
    if (!couldSurvey() || survey()->points().empty()) return;
    const Vector3 top = survey()->top();
    double evenU = 0.0;
    double evenV = 0.0;
    double near = 0.0;
    for (const SurveyPoint& point : survey()->points()) {
        const double ring = top.cross(point.direction).magnitude();
        if (ring < 0.3) continue;  // near the poles neighbours are too far apart
        near += 1.0;
        const double roundPace = point.u.pace * 2.0 * std::numbers::pi * ring;
        const double downPace = point.v.pace * std::numbers::pi;
        if (roundPace > 0.8 && roundPace < 1.25) evenU += 1.0;
        if (downPace > 0.8 && downPace < 1.25) evenV += 1.0;
    }
    constexpr double kEnough = 0.8;
    for (const auto& [axis, share] : {std::pair{"u", evenU / near}, {"v", evenV / near}}) {
        if (share >= kEnough) continue;
        const bool u = *axis == 'u';
        complain("where each texel lands, told by the tilts on a ramp and on a bow",
                 u ? "each ring round the sphere holds the map's width once, evenly"
                   : "from top to bottom the sphere holds the map's height once, evenly by angle",
                 percent(share) + " of the points fit",
                 u ? "u needs the full circle (atan2) and goes from 0 to 1; the position must be "
                     "taken relative to the sphere's centre, and the map's own width used"
                   : "v must be the polar angle over pi, of the position relative to the sphere's "
                     "centre and divided by the radius, and the map's own height used",
                 "Option 1: What to do, step 1");
    }
}

TEST_F(BumpMapping, HasTheMapsTopAtTheTop) {
    if (!couldSurvey() || survey()->points().empty()) return;
    const Vector3 top = survey()->top();
    if (!(top.y < -0.7)) return;
    complain("where row 0 of the map lands", "at the top of the sphere", "at " + words(top),
             "row 0 is the picture's top: letters stand on their heads; turn v round",
             "Option 1: What to do, step 1");
}

TEST_F(BumpMapping, TiltsMoreWhereTheMapIsSteeper) {
    if (!couldSurvey() || survey()->points().empty()) return;
    const std::optional<BumpSurvey> steep = surveyOn(kBumpFactor);
    if (!steep) return;
    constexpr double kGrows = 2.0;
    for (const auto& [axis, gentle, strong] :
         {std::tuple{"u", survey()->strengthU(), steep->strengthU()},
          std::tuple{"v", survey()->strengthV(), steep->strengthV()}}) {
        if (!(gentle > 1e-6) || strong > kGrows * gentle) continue;
        complain(std::string("two maps, one rising 17 times as fast as the other along ") + axis,
                 "a stronger tilt on the steeper one",
                 "tilts of " + inWords(gentle) + " and " + inWords(strong),
                 std::string("B_") + axis +
                     " must be the difference of heights itself, neither its "
                     "sign nor a unit vector",
                 "Option 1: What to do, step 3");
    }
}

/// Hills that wave along both axes; the columns go round without a step.
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

/// Share of the tilt that leans back from the slope, weighted by both, less what leans into it.
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

TEST_F(BumpMapping, FollowsHillsAndValleysAlongBothAxes) {
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
                 std::string("along ") + axis + " " + percent(share) + " of the tilt does",
                 "each difference is taken between neighbours along one axis only, at this row and "
                 "this column; falling slopes tilt the other way than rising ones",
                 "Option 1: What to do, step 3");
    }
}

TEST_F(BumpMapping, PointsOutwards) {
    if (!couldSurvey()) return;
    const BumpySphere sphere{{1.3, -0.7, 25.0},
                             14.0,
                             {},
                             std::make_shared<const HeightMap>(
                                 mapOf(questions::ramp(1500, kGentle), questions::level(90)))};
    const std::vector<Vector3> directions = telltaleDirections();
    const auto inward = std::ranges::count_if(directions, [&](const Vector3& direction) {
        return sphere.getNormalAt(sphere.centre() + direction * 14.0).dot(direction) <= 0.0;
    });
    if (inward * 50 <= std::ssize(directions)) return;
    complain("a nearly flat map", "normals that point away from the centre",
             std::to_string(inward) + " of " + std::to_string(directions.size()) +
                 " point to the other side",
             "the smooth normal leads from the centre to the point, not back; it is the largest "
             "part of the sum",
             "Option 1: What to do, steps 1 and 4");
}

}  // namespace
}  // namespace raytracer::tests
