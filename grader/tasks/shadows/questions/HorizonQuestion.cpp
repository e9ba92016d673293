#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
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

ShadowQuestion drawHorizonBehindBall(Draw& draw) {
    ShadowQuestion drawn = drawHorizon(draw);
    raytracer::SceneDescription& scene = drawn.question.scene;
    const auto [foot, up, material] = scene.planes.front();
    const Vector3 towards = scene.pointLights.front().position() - foot;
    const double height = towards.dot(up);
    const double highest = height + drawn.question.settings.lightSize;
    const Vector3 halfway = foot + (towards - up * height) * 0.5;
    const double gap = 0.5 * highest * draw.between(0.3, 0.5);
    const double radius = draw.between(0.5, 0.7);
    scene.spheres.push_back({halfway + up * (gap + radius), radius, drawMaterial(draw), nullptr});
    for (probe::LitPoint& point : drawn.question.points)
        point.object = 1;
    return drawn;
}

ShadowQuestion drawSunkenLight(Draw& draw) {
    constexpr double kBright = 16.0;  // so that the small |N.L| shows
    ShadowQuestion drawn = drawHorizon(draw);
    raytracer::SceneDescription& scene = drawn.question.scene;
    const auto [foot, up, material] = scene.planes.front();
    const Vector3 towards = scene.pointLights.front().position() - foot;
    const Vector3 sunken = towards - up * (2.0 * towards.dot(up));
    scene.pointLights.front() =
        drawLight(draw, foot + sunken, std::sqrt(kBright) * sunken.magnitude());
    for (probe::LitPoint& point : drawn.question.points)
        point.viewer = point.position + up * draw.between(3.0, 5.0);
    return drawn;
}

}  // namespace ticker::tasks
