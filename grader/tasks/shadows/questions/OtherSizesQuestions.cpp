#include <grader/tasks/shadows/questions/ShadowDraws.h>

#include <vector>

namespace ticker::tasks {
namespace {

// 30 points with 15 rays each give 450 lines; 280 are enough to see the size.
constexpr int kPointsOfSize = 30;
constexpr int kRaysOfSize = 15;

ShadowQuestion underLight(Draw& draw, double lightSize, double distance) {
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::otherSettings);
    raytracer::SceneDescription& scene = drawn.question.scene;
    drawn.question.settings.lightSize = lightSize;
    drawn.question.settings.shadowRayCount = kRaysOfSize;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.3);
    addLightTowards(draw, drawn, towards, distance);
    addLitPoints(draw, drawn, kPointsOfSize, 0.3);
    return drawn;
}

}  // namespace

std::vector<ShadowQuestion> drawOtherSizes(Draw& draw) {
    const double wide = draw.between(1.5, 2.0);
    const double narrow = draw.between(0.03, 0.05);
    return {underLight(draw, wide, draw.between(7.0, 9.0)),
            underLight(draw, narrow, draw.between(4.0, 6.0))};
}

}  // namespace ticker::tasks
