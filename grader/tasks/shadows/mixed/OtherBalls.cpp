#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Deck.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

namespace ticker::tasks {
namespace {

struct BallKind {
    bool isBumpy;
    Between away;    ///< distance of the light, world units
    Between radius;  ///< in distances of the light; 0: just enough to hide it
};
constexpr Between kSmallBall{0.0, 0.0};
constexpr Between kLargeBall{1.0, 1.3};
constexpr Between kNearLight{4.0, 8.0};
constexpr Between kFarLight{25.0, 40.0};
constexpr std::array kBalls{
    BallKind{true, kNearLight, kSmallBall}, BallKind{true, kNearLight, kSmallBall},
    BallKind{false, kFarLight, kLargeBall}, BallKind{false, kFarLight, kLargeBall},
    BallKind{true, kFarLight, kLargeBall},
    // The ball is 1000 away or more, beyond what code may take for infinity.
    BallKind{false, {2500.0, 3200.0}, {0.02, 0.03}}};

std::shared_ptr<const raytracer::HeightMap> drawBumps(Draw& draw) {
    constexpr int kSide = 8;
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < kSide * kSide; ++i)
        bytes.push_back(static_cast<std::uint8_t>(draw.whole(0, 255)));
    return std::make_shared<const raytracer::HeightMap>(
        raytracer::HeightMap::fromBytes(kSide, kSide, bytes));
}

/// A ball that hides the light from all points: in its way, or beside it and farther away than it.
raytracer::SphereDescription drawBall(Draw& draw, const ShadowQuestion& drawn,
                                      const Between& ofDistance) {
    constexpr double kShare = 0.45;  // of the way to the light
    constexpr double kReach = 0.15;
    const Vector3 foot = drawn.question.scene.planes.front().point;
    const Vector3 way = drawn.question.scene.pointLights.front().position() - foot;
    const double wide = kShare * 1.4 * drawn.question.settings.lightSize + (1.0 - kShare) * kReach;
    const double radius = std::max(1.3 * wide, ofDistance.number(draw) * way.magnitude());
    const Vector3 side =
        sideAt(perpendicularsOf(way.normalised()), draw.between(0.0, 2.0 * std::numbers::pi));
    return {foot + way * kShare + side * (radius - 1.3 * wide), radius, drawMaterial(draw),
            nullptr};
}

}  // namespace

std::vector<ShadowQuestion> drawOtherBalls(Draw& draw) {
    constexpr int kPoints = 4;
    std::vector<ShadowQuestion> questions;
    for (const BallKind& kind : kBalls) {
        ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::mixed);
        raytracer::SceneDescription& scene = drawn.question.scene;
        scene.ambientLighting = draw.colour(0.1, 0.5);
        const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.5);
        addLightTowards(draw, drawn, towards, kind.away.number(draw));
        scene.spheres.push_back(drawBall(draw, drawn, kind.radius));
        if (kind.isBumpy) scene.spheres.back().heightMap = drawBumps(draw);
        addLitPoints(draw, drawn, kPoints, 0.1);
        for (std::size_t i = 0; i < drawn.zones.size(); ++i) {
            const probe::LitPoint& point = drawn.question.points[i];
            drawn.zones[i] = zonesOf(scene, Surfaces{scene}, point.position, point.normal,
                                     drawn.question.settings.lightSize);
        }
        questions.push_back(std::move(drawn));
    }
    return questions;
}

}  // namespace ticker::tasks
