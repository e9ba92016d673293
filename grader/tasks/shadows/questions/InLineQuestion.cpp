#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

namespace ticker::tasks {
namespace {

constexpr int kPointsInShadow = 8;
constexpr int kPointsInLight = 4;
constexpr int kFloorInLine = 4;  // index of the floor, after four spheres

// From the middle of the shadow, world units. Where the light leans over the floor by half a radian
// the penumbra ends at 1.96.
constexpr double kBesideShadow = 2.2;

}  // namespace

ShadowQuestion drawInLine(Draw& draw) {
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    const Vector3 towards = draw.directionAround(up, 0.5);
    const double distance = draw.between(5.0, 6.0);
    const Vector3 light = foot + towards * distance;

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::inLine;
    raytracer::SceneDescription& scene = drawn.question.scene;
    const double size = drawn.question.settings.lightSize;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, light, distance));
    const auto add = [&](double along, double radius) {
        scene.spheres.push_back({foot + towards * along, radius, drawMaterial(draw), nullptr});
    };
    const auto addBehindLight = [&] {
        const double radius = draw.between(2.0, 3.0);
        add(distance + 1.5 * size + draw.between(0.2, 1.0) + radius, radius);
    };
    addBehindLight();
    const double lowRadius = draw.between(0.35, 0.4);
    add(draw.between(1.2, 1.4), lowRadius);
    const double highRadius = draw.between(0.4, 0.45);
    add(draw.between(2.2, 2.5), highRadius);
    addBehindLight();
    scene.planes.push_back({foot, up, drawMaterial(draw)});

    const Surfaces surfaces{scene};
    const Perpendiculars sides = perpendicularsOf(up);
    const auto addPoint = [&](const Vector3& point) {
        drawn.question.points.push_back(
            {kFloorInLine, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back(zonesOf(scene, surfaces, point, up, size));
    };
    for (int i = 0; i < kPointsInShadow; ++i) {
        const double x = draw.between(-0.06, 0.06);
        addPoint(foot + sides.first * x + sides.second * draw.between(-0.06, 0.06));
    }
    for (int i = 0; i < kPointsInLight; ++i)
        addPoint(foot + sides.first * (i % 2 == 0 ? kBesideShadow : -kBesideShadow) +
                 sides.second * draw.between(-0.3, 0.3));
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
