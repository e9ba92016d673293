// How normals tilt on maps that rise evenly along one axis.
#include <bump/BumpMapping.h>
#include <bump/BumpSurvey.h>
#include <raytracer/math/Vector3.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

namespace raytracer::tests::bump {
namespace {

constexpr double kSomething = 1e-6;  // radians

TEST_F(BumpMapping, TheNormalStaysSmoothWhereTheMapIsFlat) {
    if (!couldSurvey()) return;
    const double tilt = survey()->strengthOnFlat();
    if (tilt < 0.05) return;
    complain("a map of one height", "the smooth normal", "a tilt of " + inWords(tilt) + " radians",
             "take differences of heights, not heights, and make sure that the smooth normal is "
             "the one from the centre to the point",
             "Option 1: What to do, step 3");
}

TEST_F(BumpMapping, TheNormalTiltsWhereTheMapSlopes) {
    if (!couldSurvey()) return;
    for (const bool u : {true, false}) {
        const double strength = u ? survey()->strengthU() : survey()->strengthV();
        if (strength > kSomething) continue;
        const std::string axis = u ? "u" : "v";
        complain(
            "maps that rise evenly along " + axis + ", by " + inWords(kGentle.rise) +
                " over 1500 texels, and by " + std::to_string(kCoarse.bytesPerTexel) +
                " of 255 grey levels for each texel",
            "normals that are tilted on one of them at least",
            "a tilt of " + inWords(strength) + " radians",
            "B_" + axis + " is always 0 (a difference of heights kept in an int?) or never added",
            "Option 1: What to do, steps 3 and 4");
    }
}

/// Shares of the survey's points by the direction of their tilt, relative to the direction in which
/// the map rises.
struct Leaning {
    double back = 0.0;    // away from the higher side: raised
    double into = 0.0;    // towards the higher side: lowered
    double across = 0.0;  // along the other axis
};

Leaning leaningOf(const BumpSurvey& survey, AxisAtPoint SurveyPoint::*axis) {
    Leaning leaning;
    for (const SurveyPoint& point : survey.points()) {
        const AxisAtPoint& at = point.*axis;
        const double cosine = at.tilt.normalised().dot(at.along);
        // Cosines of 25 and 65 degrees. Tangents that are computed at the texel instead of at the
        // point turn a right tilt by a few degrees.
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
               ", in the tangent, or in the equation: (2) and (3) have opposite signs";
    if (leaning.across > kMost)
        return "a slope along " + axis +
               " tilts along the other axis: B_u and B_v, the two tangents, or column and row are "
               "exchanged";
    return "the tilt turns from place to place: the tangents must be those of this very point, of "
           "the same parametrisation as u and v";
}

void expectLeaningBack(const BumpSurvey& survey, AxisAtPoint SurveyPoint::*axis,
                       const std::string& name) {
    // If one axis is flat, the places of the points are unknown; another test reports it.
    if (survey.isLevel()) return;
    const Leaning leaning = leaningOf(survey, axis);
    constexpr double kEnough = 0.85;  // the map's edges and its poles are left out
    if (leaning.back >= kEnough) return;
    complain("a map that rises evenly along " + name,
             "normals that lean back from where it is higher, as a raised bump's do",
             percent(leaning.back) + " of the points lean back, " + percent(leaning.into) +
                 " lean forward, " + percent(leaning.across) + " lean sideways",
             causeOf(leaning, name), "Option 1: The sign trap; What to do, step 3");
}

TEST_F(BumpMapping, TheNormalLeansBackFromWhatIsHigherAlongU) {
    if (couldSurvey()) expectLeaningBack(*survey(), &SurveyPoint::u, "u");
}

TEST_F(BumpMapping, TheNormalLeansBackFromWhatIsHigherAlongV) {
    if (couldSurvey()) expectLeaningBack(*survey(), &SurveyPoint::v, "v");
}

TEST_F(BumpMapping, TheTiltIsStrongerWhereTheMapIsSteeper) {
    if (!couldSurvey() || survey()->points().empty()) return;
    const Slope& slope = survey()->slope();
    const int times = slope.bytesPerTexel > 0 ? 3 : 16;
    const std::optional<BumpSurvey> steep =
        surveyOn({slope.rise * times, slope.bytesPerTexel * times});
    if (!steep) return;
    constexpr double kGrows = 2.0;
    for (const auto& [axis, gentle, strong] :
         {std::tuple{"u", survey()->strengthU(), steep->strengthU()},
          std::tuple{"v", survey()->strengthV(), steep->strengthV()}}) {
        if (!(gentle > kSomething) || strong > kGrows * gentle) continue;
        complain("two maps, one rising " + std::to_string(times) +
                     " times as fast as the other along " + axis,
                 "a stronger tilt on the steeper one",
                 "tilts of " + inWords(gentle) + " and " + inWords(strong),
                 std::string("B_") + axis +
                     " must be the difference of heights itself, neither its "
                     "sign nor a unit vector",
                 "Option 1: What to do, step 3");
    }
}

}  // namespace
}  // namespace raytracer::tests::bump
