#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

constexpr int kPointsBehind = 8;

// Whether a light behind the surface contributes nothing in every reading, highlights seen by this
// viewer included.
bool isDark(const Vector3& light, const Vector3& point, const Vector3& up, const Vector3& viewer) {
    const Vector3 mirrored = (light - point).normalised().reflectIn(up);
    return mirrored.dot((viewer - point).normalised()) < -0.15;
}

}  // namespace

ShadowQuestion drawLightBehind(Draw& draw) {
    const Vector3 foot = drawPlace(draw);
    const Vector3 up = draw.directionAround((-foot).normalised(), 1.0);
    const auto light = [&](const Vector3& towards) {
        const double distance = draw.between(5.0, 9.0);
        return drawLight(draw, foot + towards * distance, distance);
    };
    ShadowQuestion drawn;
    drawn.purpose = ShadowQuestion::Purpose::lightBehind;
    SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    scene.planes.push_back({foot, up, drawMaterial(draw)});
    Vector3 below = draw.direction();
    while (std::abs(below.dot(up) + 0.5) > 0.15 || !isDark(foot + below, foot, up, {}))
        below = draw.direction();
    const Perpendiculars sides = perpendicularsOf(up);
    // About 70 degrees from each other: each ray belongs clearly to one light.
    const Vector3 aside = sides.first * draw.between(0.6, 0.8);
    scene.pointLights = {light((up + aside).normalised()), light(below),
                         light((up - aside).normalised())};
    const Surfaces surfaces{scene};
    for (int i = 0; i < kPointsBehind; ++i) {
        const double x = draw.between(-0.1, 0.1);
        const Vector3 point = foot + sides.first * x + sides.second * draw.between(-0.1, 0.1);
        const Vector3 inFront = scene.pointLights[i % 2 == 0 ? 0 : 2].position();
        Vector3 viewer = drawViewer(draw, point, up, inFront);
        for (int attempt = 0; attempt < 1000; ++attempt) {
            if (isDark(scene.pointLights[1].position(), point, up, viewer)) break;
            viewer = drawViewer(draw, point, up, inFront);
        }
        drawn.question.points.push_back({0, point, up, viewer});
        drawn.zones.push_back(
            zonesOf(scene, surfaces, point, up, drawn.question.settings.lightSize));
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
