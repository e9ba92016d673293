#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

constexpr int kPointsFaint = 6;
constexpr int kPointsClose = 30;
constexpr int kPointsOfOneRay = 48;
constexpr int kPointsOfBack = 6;

/// A floor with points in plain sight of a close light.
/// @param distance  Of the light from the middle of the floor.
/// @param lean      Largest angle between the light's direction and the floor's normal, radians.
/// @param reach     Largest coordinates of the points from the middle of the floor.
ShadowQuestion closeLightAt(Draw& draw, double distance, double lean, double reach) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::closeLight);
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const Vector3 towards = draw.directionAround(scene.planes.front().normal, lean);
    addLightTowards(draw, drawn, towards, distance);
    addLitPoints(draw, drawn, kPointsClose, reach);
    return drawn;
}

}  // namespace

ShadowQuestion drawFaintLight(Draw& draw) {
    constexpr double kFaint = 0.001;
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::faintLight);
    SceneDescription& scene = drawn.question.scene;
    // No tolerance hides the light if the ambient one is as faint.
    scene.ambientLighting = draw.colour(0.0004, 0.0008);
    const double distance = draw.between(5.0, 8.0);
    const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.6);
    addLightTowards(draw, drawn, towards, distance, kFaint);
    addLitPoints(draw, drawn, kPointsFaint, 0.5);
    return drawn;
}

ShadowQuestion drawGrazingLight(Draw& draw) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::faintLight);
    SceneDescription& scene = drawn.question.scene;
    const Vector3 up = scene.planes.front().normal;
    scene.ambientLighting = draw.colour(0.01, 0.02);
    const double facing = draw.between(0.07, 0.1);
    const double distance = draw.between(12.0, 15.0);
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 along = sideAt(sides, turn);
    addLightTowards(draw, drawn, up * facing + along * std::sqrt(1.0 - facing * facing), distance);
    addLitPoints(draw, drawn, kPointsFaint, 0.5);
    return drawn;
}

ShadowQuestion drawCloseLight(Draw& draw) {
    return closeLightAt(draw, draw.between(1.2, 1.4), 0.3, 0.1);
}

ShadowQuestion drawVeryCloseLight(Draw& draw) {
    const double radius = raytracer::RenderSettings{}.lightSize;
    return closeLightAt(draw, draw.between(1.4, 1.43) * radius, 0.15, 0.02);
}

ShadowQuestion drawOneRay(Draw& draw) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::oneRay);
    SceneDescription& scene = drawn.question.scene;
    drawn.question.settings.shadowRayCount = 1;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.6);
    addLightTowards(draw, drawn, towards, draw.between(5.0, 8.0));
    addLitPoints(draw, drawn, kPointsOfOneRay, 0.5);
    return drawn;
}

ShadowQuestion drawBackSide(Draw& draw) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::backSide);
    SceneDescription& scene = drawn.question.scene;
    const raytracer::PlaneDescription& floor = scene.planes.front();
    scene.ambientLighting = draw.colour(0.1, 0.5);
    // L leans so far that V, which is near it, is more than a right angle from R. It leans to the
    // eye's side, so that the same holds for the direction to the eye.
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    const double lean = draw.between(1.0, 1.1);
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    const Vector3 aside = sideAt(sides, turn);
    const Vector3 along = aside.dot(floor.point) > 0.0 ? -aside : aside;
    const Vector3 towards = along * std::sin(lean) - floor.normal * std::cos(lean);
    addLightTowards(draw, drawn, towards, draw.between(5.0, 8.0));
    for (int i = 0; i < kPointsOfBack; ++i) {
        const double x = draw.between(-0.2, 0.2);
        const Vector3 point =
            floor.point + sides.first * x + sides.second * draw.between(-0.2, 0.2);
        const Vector3 viewer = point + draw.directionAround(towards, 0.15) * draw.between(3.0, 5.0);
        drawn.question.points.push_back({0, point, floor.normal, viewer});
        drawn.zones.push_back({Zone::umbra});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
