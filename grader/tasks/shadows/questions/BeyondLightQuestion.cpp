#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

constexpr int kPointsBeyond = 8;

}  // namespace

ShadowQuestion drawBeyondLight(Draw& draw) {
    const Vector3 up = draw.direction();
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 foot = drawPlace(draw);
    const Vector3 towards = draw.directionAround(up, 0.6);
    const double distance = draw.between(3.0, 4.0);

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::beyondLight;
    SceneDescription& scene = drawn.question.scene;
    const double gap = 1.5 * drawn.question.settings.lightSize + draw.between(0.2, 1.0);
    const double radius = draw.between(2.0, 3.0);
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.pointLights.push_back(drawLight(draw, foot + towards * distance, distance));
    scene.spheres.push_back(
        {foot + towards * (distance + gap + radius), radius, drawMaterial(draw), nullptr});
    const Perpendiculars round = perpendicularsOf(towards);
    const double beside = 1.1 * drawn.question.settings.lightSize + radius;
    for (const double turn : {0.0, 1.0 / 3.0, 2.0 / 3.0}) {
        const double angle = 2.0 * std::numbers::pi * turn;
        const Vector3 across = round.first * std::cos(angle) + round.second * std::sin(angle);
        const Vector3 aside = across * 0.87 + towards * 0.5;  // 60 degrees from the way
        scene.spheres.push_back({foot + towards * distance + aside.normalised() * beside, radius,
                                 drawMaterial(draw), nullptr});
    }
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    for (int i = 0; i < kPointsBeyond; ++i) {
        const double x = draw.between(-0.4, 0.4);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-0.4, 0.4);
        const Vector3 viewer = drawViewer(draw, point, up, scene.pointLights[0].position());
        drawn.question.points.push_back({4, point, up, viewer});
        drawn.zones.push_back({Zone::lit});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
