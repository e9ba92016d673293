#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Deck.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr int kPointsOfSmall = 4;

/// A floor under a small light.
ShadowQuestion underSmallLight(Draw& draw, const Between& size, const Between& away) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::mixedNear);
    drawn.question.settings.lightSize = size.number(draw);
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    addLightTowards(draw, drawn, draw.directionAround(scene.planes.front().normal, 0.5),
                    away.number(draw));
    return drawn;
}

ShadowQuestion drawNearby(Draw& draw) {
    constexpr double kReach = 0.02;
    // So small that the distance of each sample, which code may take, changes the light by 2.6 % at
    // most.
    ShadowQuestion drawn = underSmallLight(draw, {0.003, 0.005}, {0.38, 0.45});
    addLitPoints(draw, drawn, kPointsOfSmall, kReach);
    return drawn;
}

/// The broadest highlight that pictures have, and a coefficient above 1.
ShadowQuestion drawBroadHighlight(Draw& draw) {
    ShadowQuestion drawn = underSmallLight(draw, {0.015, 0.025}, {4.0, 8.0});
    raytracer::Material& material = drawn.question.scene.planes.front().material;
    material.phongKD = draw.between(1.5, 2.5);
    material.phongAlpha = 1.0;
    addLitPoints(draw, drawn, kPointsOfSmall, 0.1);
    return drawn;
}

ShadowQuestion drawNarrowHighlight(Draw& draw) {
    constexpr Between kOffMirrored{0.06, 0.1};  // radians
    ShadowQuestion drawn = underSmallLight(draw, {0.015, 0.025}, {4.0, 8.0});
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.planes.front().material.phongAlpha = draw.between(150.0, 180.0);
    addLitPoints(draw, drawn, kPointsOfSmall, 0.1);
    for (probe::LitPoint& point : drawn.question.points) {
        const Vector3 L = (scene.pointLights.front().position() - point.position).normalised();
        const Vector3 mirrored = L.reflectIn(point.normal);
        const Vector3 side =
            sideAt(perpendicularsOf(mirrored), draw.between(0.0, 2.0 * std::numbers::pi));
        const double off = kOffMirrored.number(draw);
        point.viewer = point.position +
                       (mirrored * std::cos(off) + side * std::sin(off)) * draw.between(3.0, 5.0);
    }
    return drawn;
}

ShadowQuestion drawHiddenCloseBy(Draw& draw) {
    ShadowQuestion drawn = underSmallLight(draw, {0.008, 0.012}, {4.0, 8.0});
    raytracer::SceneDescription& scene = drawn.question.scene;
    addLitPoints(draw, drawn, kPointsOfSmall, 0.1);
    const Vector3 light = scene.pointLights.front().position();
    const Vector3 towards = (light - scene.planes.front().point).normalised();
    // Outside of the margin of 0.02 that some leave before the light, inside of one of 0.05, which
    // loses shadows.
    scene.planes.push_back({light - towards * draw.between(0.035, 0.045),
                            draw.directionAround(towards, 0.1), drawMaterial(draw)});
    for (std::vector<Zone>& zones : drawn.zones)
        zones = {Zone::umbra};
    return drawn;
}

}  // namespace

std::vector<ShadowQuestion> drawSmallLights(Draw& draw) {
    return {drawNearby(draw), drawNarrowHighlight(draw), drawHiddenCloseBy(draw),
            drawBroadHighlight(draw)};
}

}  // namespace ticker::tasks
