#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <numbers>

namespace ticker::tasks {
namespace {

// With ten rays each, a fifth or more of them below the horizon: the chance that none is below it
// is under 1e-20 for every accepted shape.
constexpr int kPointsLow = 24;

}  // namespace

ShadowQuestion drawHorizon(Draw& draw) {
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    const Perpendiculars sides = perpendicularsOf(up);
    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::horizon;
    raytracer::SceneDescription& scene = drawn.question.scene;
    const double height = draw.between(0.15, 0.25) * drawn.question.settings.lightSize;
    const double distance = draw.between(3.0, 5.0);
    const Vector3 light = foot + sides.first * distance + up * height;
    scene.ambientLighting = draw.colour(0.05, 0.1);
    scene.pointLights.push_back(drawLight(draw, light, distance));
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    for (int i = 0; i < kPointsLow; ++i) {
        const double x = draw.between(-0.3, 0.3);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-0.3, 0.3);
        drawn.question.points.push_back({0, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back({Zone::penumbra});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
