// How much of one light arrives.
#include <questions/RayGeometry.h>
#include <shadows/Room.h>
#include <shadows/SoftShadows.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace raytracer::tests::shadows {
namespace {

TEST_F(SoftShadows, AllLightArrivesWhereNothingIsInTheWay) {
    const Vector3 point = floorAt(1.5);
    const Trial trial{emptyRoom(), point, 200};
    const questions::PhongTerms terms = unshadowed(emptyRoom(), 0, point);
    const ColourRGB expected = ambientOnly() + terms.sum();
    // Phong for each sample differs from Phong for the light's centre by 1 % here.
    if (isNear(trial.mean(), expected, 0.04)) return;
    std::string cause =
        "the sum over the shadow rays must be divided by their number, and the "
        "share multiply diffuse and specular light once";
    if (isNear(trial.mean(), ambientOnly(), 0.02))
        cause =
            "every ray was taken for blocked: the comparison is the wrong way round, or the "
            "ray hits the surface that it starts from";
    complain("a point of the floor, nothing between it and the light", words(expected),
             words(trial.mean()) + " on average", cause, "Soft shadows (T2.1), step 3");
}

TEST_F(SoftShadows, OnlyAmbientLightIsLeftInFullShadow) {
    const Vector3 point = floorAt(0.2);
    const Trial trial{roomWithBall(), point, 50};
    if (isNear(trial.mean(), ambientOnly(), 1e-6)) return;
    const questions::PhongTerms terms = unshadowed(roomWithBall(), 0, point);
    std::string cause = "a ray that hits the ball before the light must not count";
    if (isNear(trial.mean(), ambientOnly() + terms.specular, 0.02))
        cause = "the specular light is not scaled by the share of rays that arrive";
    else if (isNear(trial.mean(), ambientOnly() + terms.diffuse, 0.02))
        cause = "the diffuse light is not scaled by the share of rays that arrive";
    else if (trial.mean().r < ambientOnly().r)
        cause = "the ambient light comes from everywhere: it is never shadowed";
    else if (isNear(trial.mean(), ambientOnly() + terms.sum(), 0.04))
        cause = "lit and shadowed are exchanged, or the ball is never hit";
    complain("a point of the floor under the middle of the ball",
             words(ambientOnly()) + ", the ambient light", words(trial.mean()), cause,
             "Soft shadows (T2.1), step 3");
}

/// Whether all calls gave the same value. One pattern of aim points for all points of the scene is
/// accepted; its few points give the share only roughly.
bool hasOnePattern(const Trial& trial, const Vector3& point) {
    const double first = shareOf(trial.colours().front(), point);
    return std::all_of(
        trial.colours().begin(), trial.colours().end(),
        [&](const ColourRGB& colour) { return std::abs(shareOf(colour, point) - first) < 0.02; });
}

/// Number of calls with a share between 0 and 1.
std::ptrdiff_t countBetween(const Trial& trial, const Vector3& point) {
    return std::count_if(trial.colours().begin(), trial.colours().end(),
                         [&](const ColourRGB& colour) {
                             const double share = shareOf(colour, point);
                             return share > 0.04 && share < 0.96;
                         });
}

TEST_F(SoftShadows, AShareOfTheLightArrivesAtTheEdgeOfAShadow) {
    const Vector3 point = floorWhereLightIsClearBy(0.0);
    const Trial trial{roomWithBall(), point, 300};
    const std::ptrdiff_t between = countBetween(trial, point);
    const std::string asked = "a point from where the ball hides about half of the light";
    if (between < 150) {
        complain(asked, "shares like 0.4 or 0.6 of the light",
                 std::to_string(between) + " of 300 calls gave a share between none and all",
                 "each ray counts for itself: cast settings().shadowRayCount of them at different "
                 "points of the light, count those that arrive, and divide as double",
                 "Soft shadows (T2.1), steps 1 and 2");
        return;
    }
    const double share = shareOf(trial.mean(), point);
    if ((share > 0.44 && share < 0.7) || hasOnePattern(trial, point)) return;
    complain(asked, "about half of the light on average", inWords(share) + " of it",
             "the aim points must lie all around the light's centre, and "
             "the light grow in proportion to the share of rays that arrive",
             "Soft shadows (T2.1), steps 1 to 3");
}

TEST_F(SoftShadows, ShadowEdgesAreAsWideAsTheRadiusOfTheLightMakesThem) {
    const double radius = handout_.lightSize;
    // At 0.6 radii behind the rim, 3 to 25 % of the light is visible, for aim points in a ball, on
    // its surface, or crowded in its middle; at more than one radius none is.
    struct Place {
        double clear;
        double least;
        double most;
    };
    for (const Place& place :
         {Place{-1.35 * radius, 0.0, 1e-9}, Place{-0.6 * radius, 0.01, 0.35},
          Place{0.6 * radius, 0.65, 0.995}, Place{1.35 * radius, 0.96, 1.04}}) {
        const Vector3 point = floorWhereLightIsClearBy(place.clear);
        const Trial trial{roomWithBall(), point, 300};
        const double share = shareOf(trial.mean(), point);
        if (share >= place.least - 1e-9 && share <= place.most) continue;
        if (std::abs(place.clear) < radius && hasOnePattern(trial, point)) continue;
        if (countBetween(trial, point) == 0 && share > 0.04 && share < 0.96)
            return;  // all or nothing: the test above reports it
        const bool hidden = place.clear < 0.0;
        const bool tooWide = hidden ? share > place.most : share < place.least;
        complain("a point from where the light's centre stands " +
                     inWords(std::abs(place.clear) / radius) + " radii " +
                     (hidden ? "behind" : "outside") + " the ball's rim",
                 place.most < 1e-6 ? "none of the light"
                                   : "a share of the light from " + inWords(place.least) + " to " +
                                         inWords(std::min(1.0, place.most)),
                 inWords(share),
                 tooWide ? "the light is too large: a point in a ball of radius "
                           "settings().lightSize is added to the light's position, not to the unit "
                           "direction towards it"
                         : "the light is too small: is settings().lightSize its radius?",
                 "Soft shadows (T2.1), step 1");
        return;
    }
}

}  // namespace
}  // namespace raytracer::tests::shadows
