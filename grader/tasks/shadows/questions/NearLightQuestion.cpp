#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

namespace ticker::tasks {
namespace {

constexpr int kPointsBeforePlane = 8;
constexpr int kFloorBeforePlane = 0;  // index of the floor, before the plane

// Distance of the plane from the light's centre, in radii of the light.
constexpr double kNearestPlane = 1.2;
constexpr double kFarthestPlane = 1.3;

}  // namespace

ShadowQuestion drawNearLight(Draw& draw) {
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    const Vector3 towards = draw.directionAround(up, 0.6);
    const double distance = draw.between(20.0, 30.0);
    const Vector3 light = foot + towards * distance;

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::nearLight;
    raytracer::SceneDescription& scene = drawn.question.scene;
    const double size = drawn.question.settings.lightSize;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, light, distance));
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    const double gap = draw.between(kNearestPlane, kFarthestPlane) * size;
    const Vector3 across = draw.directionAround(towards, 0.1);
    scene.planes.push_back(
        {light - towards * gap, draw.whole(0, 1) == 0 ? across : -across, drawMaterial(draw)});
    const Perpendiculars sides = perpendicularsOf(up);
    for (int i = 0; i < kPointsBeforePlane; ++i) {
        const double x = draw.between(-0.5, 0.5);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-0.5, 0.5);
        drawn.question.points.push_back(
            {kFloorBeforePlane, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back({Zone::umbra});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
