#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <cstddef>
#include <numbers>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

constexpr int kPointsSeveral = 24;
constexpr int kPointsInBothShadows = 6;

}  // namespace

ShadowQuestion drawSeveralLights(Draw& draw) {
    const Vector3 up = draw.direction();
    const Perpendiculars sides = perpendicularsOf(up);
    const Vector3 foot = drawPlace(draw);

    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::severalLights;
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    for (int i = 0; i < 3; ++i) {
        const double angle = turn + i * 2.0 * std::numbers::pi / 3.0;
        const Vector3 around = sideAt(sides, angle);
        const Vector3 towards = (up + around * draw.between(1.3, 1.7)).normalised();
        const bool isFar = i < 2;
        const double distance = isFar ? draw.between(8.0, 9.0) : draw.between(5.0, 5.3);
        scene.pointLights.push_back(drawLight(draw, foot + towards * distance, distance));
        const double size = draw.between(0.25, 0.35);
        const double along = isFar
                                 ? draw.between(1.6, 2.2)
                                 : distance + 1.5 * drawn.question.settings.lightSize + 2.0 * size;
        scene.spheres.push_back({foot + towards * along, size, drawMaterial(draw), nullptr});
    }
    scene.planes.push_back({foot, up, drawMaterial(draw)});

    const Surfaces surfaces{scene};
    const double radius = drawn.question.settings.lightSize;
    for (int i = 0; i < kPointsSeveral; ++i) {
        // The first ones lie in the shadow of both spheres, the others anywhere.
        const double reach = i < kPointsInBothShadows ? 0.06 : 0.7;
        const double x = draw.between(-reach, reach);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-reach, reach);
        const auto facing = static_cast<std::size_t>(draw.whole(0, 2));
        const Vector3 light = scene.pointLights[facing].position();
        drawn.question.points.push_back({3, point, up, drawViewer(draw, point, up, light)});
        drawn.zones.push_back(zonesOf(scene, surfaces, point, up, radius));
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
