#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <algorithm>

namespace ticker::tasks {
namespace {

constexpr int kLitPoints = 2;
constexpr int kRimPoints = 4;  // at either rim of the penumbra

/// Whether a few hundredths of the light's surface are hidden (`isNearlyLit`) or visible.
bool isAtRim(const ShadowQuestion& drawn, const Vector3& point, bool isNearlyLit) {
    constexpr double kLeast = 0.02;
    constexpr double kMost = 0.045;
    const raytracer::SceneDescription& scene = drawn.question.scene;
    const Vector3 start = rayStart(point, scene.planes.front().normal);
    const double visible = visibleShare(Surfaces{scene}, start, scene.pointLights[0].position(),
                                        drawn.question.settings.lightSize);
    const double rest = isNearlyLit ? 1.0 - visible : visible;
    return rest > kLeast && rest < kMost;
}

}  // namespace

ShadowQuestion drawManyRays(Draw& draw) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::manyRays);
    drawn.question.settings.shadowRayCount = draw.whole(280, 320);
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.2);
    const raytracer::PlaneDescription floor = scene.planes.front();
    const Vector3 towards = draw.directionAround(floor.normal, 0.3);
    addLightTowards(draw, drawn, towards, draw.between(5.0, 6.0));
    scene.spheres.push_back(
        {floor.point + towards * 2.0, draw.between(0.4, 0.5), drawMaterial(draw), nullptr});

    // The shadow is about 1.5 wide, penumbra and all.
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    constexpr int kMostTries = 20000;
    for (const bool isNearlyLit : {true, false}) {
        int left = kRimPoints;
        for (int tries = 0; left > 0 && tries < kMostTries; ++tries) {
            const double x = draw.between(-1.5, 1.5);
            const Vector3 point =
                floor.point + sides.first * x + sides.second * draw.between(-1.5, 1.5);
            if (!isAtRim(drawn, point, isNearlyLit)) continue;
            const Vector3 viewer =
                drawViewer(draw, point, floor.normal, scene.pointLights[0].position());
            drawn.question.points.push_back({1, point, floor.normal, viewer});
            drawn.zones.push_back({Zone::penumbra});
            --left;
        }
    }
    for (int i = 0; i < kLitPoints; ++i) {
        const Vector3 point = floor.point + sides.first * (i == 0 ? 4.0 : -4.0);
        const Vector3 viewer =
            drawViewer(draw, point, floor.normal, scene.pointLights[0].position());
        drawn.question.points.push_back({1, point, floor.normal, viewer});
        drawn.zones.push_back({Zone::lit});
    }
    setCapacity(drawn);
    return drawn;
}

}  // namespace ticker::tasks
