#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;
using raytracer::SceneDescription;

// Points for each zone of a one-light question. With ten rays each that suffices for every exact
// statement.
constexpr int kPointsForEachZone = 12;
constexpr int kPointsOnSphere = 6;
constexpr int kPointsBesideWall = 8;

// Groups of two, five or ten rays leave some over. Below the handout's number, so that code with
// that number hard-coded casts enough.
constexpr int kOddRays = 7;

// On the side that faces the light the sphere has no shadow: rays that hit the surface they leave
// show here (shadow acne).
void addPointsOnSphere(Draw& draw, ShadowQuestion& drawn) {
    const SceneDescription& scene = drawn.question.scene;
    const raytracer::SphereDescription& sphere = scene.spheres.front();
    const Vector3 light = scene.pointLights.front().position();
    for (int i = 0; i < kPointsOnSphere; ++i) {
        const Vector3 normal = draw.directionAround((light - sphere.centre).normalised(), 0.9);
        const Vector3 point = sphere.centre + normal * sphere.radius;
        drawn.question.points.push_back({0, point, normal, drawViewer(draw, point, normal, light)});
        drawn.zones.push_back({Zone::lit});
    }
}

/// A floor, a sphere `height` above it and a light above that, in a random orientation.
ShadowQuestion drawOneLight(Draw& draw, const raytracer::RenderSettings& settings, Purpose purpose,
                            double height) {
    // The floor can be seen from the lens.
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.1);
    const double radius = draw.between(0.55, 0.75);
    const Vector3 ball = foot + up * (height * draw.between(0.8, 1.2));
    const Vector3 towards = draw.directionAround(up, 0.5);
    const Vector3 light = ball + towards * draw.between(3.0, 4.0);

    ShadowQuestion drawn;
    drawn.purpose = purpose;
    drawn.question.settings = settings;
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, light, (light - foot).magnitude()));
    scene.spheres.push_back({ball, radius, drawMaterial(draw), nullptr});
    scene.planes.push_back({foot, up, drawMaterial(draw)});

    const Surfaces surfaces{scene};
    const Vector3 axis = (ball - light).normalised();
    const double rim = std::asin(radius / (ball - light).magnitude());
    const int share = purpose == Purpose::oneLight ? kPointsForEachZone : kPointsForEachZone / 2;
    std::array<int, 3> wanted{share, share, share};
    for (int attempt = 0; attempt < 20000; ++attempt) {
        const Vector3 ray = draw.directionAround(axis, 2.2 * rim);
        if (ray.dot(up) > -0.2) continue;
        const Vector3 point = light + ray * ((foot - light).dot(up) / ray.dot(up));
        const std::vector<Zone> zones = zonesOf(scene, surfaces, point, up, settings.lightSize);
        int& left = wanted[static_cast<std::size_t>(zones[0])];
        if (left == 0) continue;
        --left;
        const Vector3 viewer =
            left % 2 == 0 ? drawLensPoint(draw, settings) : drawViewer(draw, point, up, light);
        drawn.question.points.push_back({1, point, up, viewer});
        drawn.zones.push_back(zones);
        if (std::all_of(wanted.begin(), wanted.end(), [](int count) { return count == 0; })) break;
    }
    addPointsOnSphere(draw, drawn);
    setCapacity(drawn);
    return drawn;
}

/// A floor with a wall on it; half of the points are on the light's side of the wall, half behind
/// it.
/// @param facing  1: the wall's normal points to the light's side; -1: away from it.
ShadowQuestion drawPlaneShadow(Draw& draw, double facing) {
    const Vector3 up = draw.direction();
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 foot = drawPlace(draw);
    const Vector3 above = up * draw.between(2.0, 4.0);
    const Vector3 light = foot + above + sides.first * draw.between(2.0, 4.0);

    ShadowQuestion drawn;
    drawn.purpose = Purpose::planeShadow;
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, light, (light - foot).magnitude()));
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    const Vector3 wall = (sides.first + up * draw.between(-0.3, 0.3)).normalised();
    scene.planes.push_back({foot, wall * facing, drawMaterial(draw)});
    const Surfaces surfaces{scene};
    for (int i = 0; i < kPointsBesideWall; ++i) {
        const double side = i % 2 == 0 ? 1.0 : -1.0;
        const Vector3 across = sides.first * (side * draw.between(0.2, 1.5));
        const Vector3 point = foot + across + sides.second * draw.between(-1.0, 1.0);
        drawn.question.points.push_back({0, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back(
            zonesOf(scene, surfaces, point, up, drawn.question.settings.lightSize));
    }
    setCapacity(drawn);
    return drawn;
}

Vector3 turned(const Vector3& vector, const Vector3& axis, double angle) {
    return vector * std::cos(angle) + axis.cross(vector) * std::sin(angle) +
           axis * (axis.dot(vector) * (1.0 - std::cos(angle)));
}

// Three directions at right angles, since one shows what another hides. Each is near an axis of the
// world: seen from there, points that crowd at two poles on that axis look round, while an ellipse
// that faces the point does not.
std::array<Vector3, 3> drawNearAxes(Draw& draw) {
    constexpr double kLeast = 0.1;
    constexpr double kMost = 0.25;
    const Vector3 axis = draw.direction();
    const double angle = draw.between(kLeast, kMost);
    std::array<Vector3, 3> drawn{Vector3{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (Vector3& towards : drawn)
        towards = turned(towards * (draw.whole(0, 1) == 0 ? -1.0 : 1.0), axis, angle);
    return drawn;
}

}  // namespace

std::vector<ShadowQuestion> drawShadowQuestions(std::uint64_t seed) {
    Draw draw{seed, 21};
    const raytracer::RenderSettings handout;
    std::vector<ShadowQuestion> questions;
    questions.push_back(drawOneLight(draw, handout, Purpose::oneLight, 1.7));
    // Seen from far away, the distance of a sample, which is not visible, depends less on its place
    // in the light.
    questions.push_back(drawOneLight(draw, handout, Purpose::oneLight, 20.0));
    questions.push_back(drawSeveralLights(draw));
    questions.push_back(drawBeyondLight(draw));

    for (const Vector3& towards : drawNearAxes(draw))
        questions.push_back(drawFarLight(draw, towards));

    raytracer::RenderSettings other;
    other.shadowRayCount = 2 * draw.whole(6, 8) + 1;
    other.lightSize = draw.between(0.15, 0.22);
    questions.push_back(drawOneLight(draw, other, Purpose::otherSettings, 1.7));
    for (const double facing : {1.0, -1.0})
        questions.push_back(drawPlaneShadow(draw, facing));
    for (const auto drawNext : {drawLightBehind, drawHorizon, drawInLine, drawContact, drawLowLight,
                                drawNearLight, drawPureLights, drawPureSurfaces, drawFaintLight,
                                drawGrazingLight, drawCloseLight, drawBackSide, drawEightLights})
        questions.push_back(drawNext(draw));
    raytracer::RenderSettings odd;
    odd.shadowRayCount = kOddRays;
    questions.push_back(drawOneLight(draw, odd, Purpose::oddCount, 1.7));
    for (const auto drawNext : {drawMaterials, drawEnclosed, drawBetweenLights, drawBehindAfterLit})
        for (ShadowQuestion& drawn : drawNext(draw))
            questions.push_back(std::move(drawn));
    questions.push_back(drawManyRays(draw));
    questions.push_back(drawLightsInLine(draw));
    questions.push_back(drawVeryCloseLight(draw));
    questions.push_back(drawOneRay(draw));
    for (const auto drawNext : {drawMixedScenes, drawOtherBalls, drawVeryFarLights, drawManyLights,
                                drawSmallLights, drawPenumbraEdges, drawOtherSizes})
        for (ShadowQuestion& drawn : drawNext(draw))
            questions.push_back(std::move(drawn));
    questions.push_back(drawHorizonBehindBall(draw));
    questions.push_back(drawSunkenLight(draw));
    return questions;
}

}  // namespace ticker::tasks
