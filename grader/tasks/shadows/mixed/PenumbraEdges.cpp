#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Deck.h>
#include <grader/tasks/support/Surfaces.h>

#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr int kPointsOfEdge = 8;  // at either edge of the penumbra
constexpr int kEdgeTries = 100'000;

}  // namespace

std::vector<ShadowQuestion> drawPenumbraEdges(Draw& draw) {
    constexpr double kReach = 2.0;
    constexpr Between kSmallShare{0.04, 0.15};  // of aims on the light's surface; a ball has less
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::mixedNear);
    // With the handout's ten rays no share is so small.
    drawn.question.settings.shadowRayCount = draw.whole(48, 56);
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const raytracer::PlaneDescription floor = scene.planes.front();
    addLightTowards(draw, drawn, draw.directionAround(floor.normal, 0.3), draw.between(6.0, 8.0));
    const Vector3 light = scene.pointLights.front().position();
    scene.spheres.push_back({floor.point + (light - floor.point) * draw.between(0.4, 0.5),
                             draw.between(0.45, 0.6), drawMaterial(draw), nullptr});
    const Surfaces surfaces{scene};
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    const double radius = drawn.question.settings.lightSize;
    int dark = 0;
    int bright = 0;
    for (int i = 0; i < kEdgeTries && dark + bright < 2 * kPointsOfEdge; ++i) {
        const Vector3 side = sideAt(sides, draw.between(0.0, 2.0 * std::numbers::pi));
        const Vector3 point = floor.point + side * draw.between(0.0, kReach);
        const double share = visibleShare(surfaces, rayStart(point, floor.normal), light, radius);
        const bool isDark = kSmallShare.low <= share && share <= kSmallShare.high;
        const bool isBright = kSmallShare.low <= 1.0 - share && 1.0 - share <= kSmallShare.high;
        int& count = isDark ? dark : bright;
        if ((!isDark && !isBright) || count == kPointsOfEdge) continue;
        ++count;
        drawn.question.points.push_back(
            {1, point, floor.normal, drawViewer(draw, point, floor.normal, light)});
        drawn.zones.push_back({Zone::penumbra});
    }
    setCapacity(drawn);
    return {drawn};
}

}  // namespace ticker::tasks
