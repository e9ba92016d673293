// How the map lies on the sphere.
#include <bump/BumpMapping.h>
#include <bump/BumpSurvey.h>
#include <raytracer/math/Vector3.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <utility>

namespace raytracer::tests::bump {
namespace {

TEST_F(BumpMapping, TheMapLiesOnceRoundTheSphere) {
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

TEST_F(BumpMapping, TheTopOfTheMapLiesAtTheTop) {
    if (!couldSurvey() || survey()->points().empty()) return;
    const Vector3 top = survey()->top();
    if (!(top.y < -0.7)) return;
    complain("where row 0 of the map lands", "at the top of the sphere", "at " + words(top),
             "row 0 is the picture's top: letters stand on their heads; turn v round",
             "Option 1: What to do, step 1");
}

}  // namespace
}  // namespace raytracer::tests::bump
