#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

constexpr int kPointsInContact = 12;
constexpr int kFloorOfBall = 1;  // index of the floor, after the ball

}  // namespace

ShadowQuestion drawContact(Draw& draw) {
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    const Perpendiculars sides = perpendicularsOf(up);
    // At this distance code still passes that ignores hits within a ten-thousandth of the way to
    // the light; code that ignores those within a thousandth fails.
    const double distance = draw.between(24.0, 26.0);
    const Vector3 light = foot + draw.directionAround(up, 0.3) * distance;
    const double radius = draw.between(0.5, 0.7);

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::contact;
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, light, distance));
    scene.spheres.push_back({foot + up * radius, radius, drawMaterial(draw), nullptr});
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    const Surfaces surfaces{scene};
    for (int i = 0; i < kPointsInContact; ++i) {
        // Every accepted start is below the ball, and limits of 0.004 against shadow acne still
        // pass.
        const double gap = draw.between(0.006, 0.008);
        const double beside = std::sqrt(gap * (2.0 * radius - gap));
        const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
        const Vector3 point = foot + sideAt(sides, turn) * beside;
        drawn.question.points.push_back(
            {kFloorOfBall, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back(
            zonesOf(scene, surfaces, point, up, drawn.question.settings.lightSize));
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
