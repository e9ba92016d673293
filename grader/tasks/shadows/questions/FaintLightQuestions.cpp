#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

constexpr int kPointsFaint = 6;
constexpr int kPointsClose = 24;

/// Points of the floor under the question's only light, all of them lit.
void addLitPoints(Draw& draw, ShadowQuestion& drawn, int count, double reach) {
    const SceneDescription& scene = drawn.question.scene;
    const raytracer::PlaneDescription& floor = scene.planes.front();
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    const Vector3 light = scene.pointLights.front().position();
    for (int i = 0; i < count; ++i) {
        const double x = draw.between(-reach, reach);
        const Vector3 point =
            floor.point + sides.first * x + sides.second * draw.between(-reach, reach);
        const Vector3 viewer = drawViewer(draw, point, floor.normal, light);
        drawn.question.points.push_back({0, point, floor.normal, viewer});
        drawn.zones.push_back({Zone::lit});
    }
    setCapacity(drawn);
}

/// A floor in front of the camera.
ShadowQuestion withFloor(Draw& draw, ShadowQuestion::Purpose purpose) {
    ShadowQuestion drawn;
    drawn.purpose = purpose;
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    drawn.question.scene.planes.push_back({foot, up, drawMaterial(draw)});
    return drawn;
}

}  // namespace

ShadowQuestion drawFaintLight(Draw& draw) {
    constexpr double kFaint = 0.005;  // of the usual light
    ShadowQuestion drawn = withFloor(draw, ShadowQuestion::Purpose::faintLight);
    SceneDescription& scene = drawn.question.scene;
    const raytracer::PlaneDescription& floor = scene.planes.front();
    // No tolerance hides the light if the ambient one is as faint.
    scene.ambientLighting = draw.colour(0.002, 0.004);
    const double distance = draw.between(5.0, 8.0);
    const Vector3 towards = draw.directionAround(floor.normal, 0.6);
    const raytracer::PointLight usual = drawLight(draw, floor.point + towards * distance, distance);
    scene.pointLights.emplace_back(usual.position(), usual.colour(), usual.intensity() * kFaint);
    addLitPoints(draw, drawn, kPointsFaint, 0.5);
    return drawn;
}

ShadowQuestion drawGrazingLight(Draw& draw) {
    ShadowQuestion drawn = withFloor(draw, ShadowQuestion::Purpose::faintLight);
    SceneDescription& scene = drawn.question.scene;
    const raytracer::PlaneDescription& floor = scene.planes.front();
    scene.ambientLighting = draw.colour(0.01, 0.02);
    const double facing = draw.between(0.07, 0.1);
    const double distance = draw.between(12.0, 15.0);
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    const Vector3 along = sides.first * std::cos(turn) + sides.second * std::sin(turn);
    const Vector3 towards = floor.normal * facing + along * std::sqrt(1.0 - facing * facing);
    scene.pointLights.push_back(drawLight(draw, floor.point + towards * distance, distance));
    addLitPoints(draw, drawn, kPointsFaint, 0.5);
    return drawn;
}

ShadowQuestion drawCloseLight(Draw& draw) {
    ShadowQuestion drawn = withFloor(draw, ShadowQuestion::Purpose::closeLight);
    SceneDescription& scene = drawn.question.scene;
    const raytracer::PlaneDescription& floor = scene.planes.front();
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const double distance = draw.between(1.2, 1.4);
    const Vector3 towards = draw.directionAround(floor.normal, 0.3);
    scene.pointLights.push_back(drawLight(draw, floor.point + towards * distance, distance));
    addLitPoints(draw, drawn, kPointsClose, 0.1);
    return drawn;
}

}  // namespace ticker::tasks
