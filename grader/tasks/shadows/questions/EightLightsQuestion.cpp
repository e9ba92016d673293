#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace ticker::tasks {
namespace {

constexpr int kLights = 8;
constexpr int kPointsAmongLights = 18;

}  // namespace

ShadowQuestion drawEightLights(Draw& draw) {
    const Vector3 up = draw.direction();
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 foot = drawPlace(draw);

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::eightLights;
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    // 60 degrees from the normal, and 39 from each other: each ray belongs clearly to one light.
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    for (int i = 0; i < kLights; ++i) {
        const double angle = turn + i * 2.0 * std::numbers::pi / kLights;
        const Vector3 around = sideAt(sides, angle);
        const double distance = draw.between(8.0, 9.0);
        const Vector3 towards = up * 0.5 + around * std::sqrt(0.75);
        scene.pointLights.push_back(drawLight(draw, foot + towards * distance, distance));
    }
    for (int i = 0; i < kPointsAmongLights; ++i) {
        const double x = draw.between(-0.5, 0.5);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-0.5, 0.5);
        const auto facing = static_cast<std::size_t>(draw.whole(0, kLights - 1));
        const Vector3 light = scene.pointLights[facing].position();
        drawn.question.points.push_back({0, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.emplace_back(scene.pointLights.size(), Zone::lit);
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
