#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace ticker::tasks {

std::vector<ShadowQuestion> drawEnclosed(Draw& draw) {
    constexpr int kPoints = 4;
    constexpr double kBall = 1.2;
    std::vector<ShadowQuestion> questions;
    for (const bool isAroundLight : {true, false}) {
        ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::enclosed);
        raytracer::SceneDescription& scene = drawn.question.scene;
        scene.ambientLighting = draw.colour(0.1, 0.5);
        const Vector3 foot = scene.planes.front().point;
        const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.5);
        const double distance = draw.between(5.0, 6.0);
        addLightTowards(draw, drawn, towards, distance);
        const Vector3 centre = isAroundLight ? foot + towards * distance : foot;
        // The ball has the floor's material, so that only its address distinguishes the two
        // objects.
        scene.spheres.push_back({centre, kBall, scene.planes.front().material, nullptr});
        addLitPoints(draw, drawn, kPoints, 0.4);
        std::ranges::fill(drawn.zones, std::vector{Zone::umbra});
        questions.push_back(std::move(drawn));
    }
    return questions;
}

}  // namespace ticker::tasks
