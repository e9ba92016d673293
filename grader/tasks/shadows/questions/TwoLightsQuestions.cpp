#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;
using raytracer::SceneDescription;

constexpr int kPoints = 6;

}  // namespace

// From the floor the ball reaches 37 degrees to either side of its centre. The near light is 12
// degrees off that, and reaches 9 degrees to either side of its own. It ends 3.2 from the floor,
// and the ball begins at 4.1.
std::vector<ShadowQuestion> drawBetweenLights(Draw& draw) {
    constexpr double kBall = 6.0;
    constexpr double kToBall = 10.0;
    constexpr double kOff = 0.21;
    constexpr double kNear = 2.6;
    constexpr double kFar = 24.0;
    constexpr double kFaint = 0.3;  // of the hidden light, so that the near one's loss shows
    std::vector<ShadowQuestion> questions;
    for (const bool hiddenFirst : {true, false}) {
        ShadowQuestion drawn = onFloor(draw, Purpose::betweenLights);
        SceneDescription& scene = drawn.question.scene;
        scene.ambientLighting = draw.colour(0.1, 0.2);
        const Vector3 middle = draw.directionAround(scene.planes.front().normal, 0.3);
        const Vector3 aside = perpendicularsOf(middle).first;
        addLightTowards(draw, drawn, sideAt({middle, aside}, -kOff), kNear);
        addLightTowards(draw, drawn, sideAt({middle, aside}, kOff), kFar, kFaint);
        const Vector3 centre = scene.planes.front().point + middle * kToBall;
        scene.spheres.push_back({centre, kBall, drawMaterial(draw), nullptr});
        addLitPoints(draw, drawn, kPoints, 0.2);
        std::ranges::fill(drawn.zones, std::vector{Zone::lit, Zone::umbra});
        if (hiddenFirst) {
            std::swap(scene.pointLights[0], scene.pointLights[1]);
            std::ranges::fill(drawn.zones, std::vector{Zone::umbra, Zone::lit});
        }
        questions.push_back(std::move(drawn));
    }
    return questions;
}

ShadowQuestion drawLightsInLine(Draw& draw) {
    ShadowQuestion drawn = onFloor(draw, Purpose::lightsInLine);
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.2);
    const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.5);
    addLightTowards(draw, drawn, towards, draw.between(6.0, 8.0));
    addLightTowards(draw, drawn, towards, draw.between(20.0, 30.0));
    addLitPoints(draw, drawn, kPoints, 0.05);
    return drawn;
}

// L is 9 degrees below the floor and V 3 above it, on the other side: R.V is 0.98.
std::vector<ShadowQuestion> drawBehindAfterLit(Draw& draw) {
    constexpr double kBelow = 0.15;
    constexpr double kAbove = 0.06;
    constexpr double kDistance = 8.0;
    ShadowQuestion alone = onFloor(draw, Purpose::behindAlone);
    SceneDescription& scene = alone.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.2);
    const raytracer::PlaneDescription& floor = scene.planes.front();
    const Perpendiculars sides = perpendicularsOf(floor.normal);
    const double turn = draw.between(0.0, 2.0 * std::numbers::pi);
    const Vector3 along = sideAt(sides, turn);
    addLightTowards(draw, alone, sideAt({along, floor.normal}, -kBelow), kDistance);
    raytracer::PointLight& behind = scene.pointLights.front();
    behind = {behind.position(), draw.colour(0.8, 1.0), behind.intensity()};
    addLitPoints(draw, alone, kPoints, 0.2);
    std::ranges::fill(alone.zones, std::vector{Zone::umbra});
    for (probe::LitPoint& point : alone.question.points)
        point.viewer = point.position + sideAt({along * -1.0, floor.normal}, kAbove) * 4.0;

    ShadowQuestion after = alone;
    after.purpose = Purpose::behindAfter;
    const Vector3 across = sideAt(sides, turn + std::numbers::pi / 2.0);
    addLightTowards(draw, after, (floor.normal + across).normalised(), kDistance);
    auto& lights = after.question.scene.pointLights;
    std::swap(lights[0], lights[1]);
    std::ranges::fill(after.zones, std::vector{Zone::lit, Zone::umbra});
    setCapacity(after);
    return {alone, after};
}

}  // namespace ticker::tasks
