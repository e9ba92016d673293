#include <grader/tasks/shadows/checks/LitRender.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <cstddef>

namespace ticker::tasks {
namespace {

// 750 lens rays, each with ten shadow rays to two lights; the log holds six times as many.
constexpr int kLitWidth = 5;
constexpr int kLitHeight = 3;
constexpr std::size_t kLitEventsForEachRay = 6 * 25;

}  // namespace

// At the depth of the spheres the picture reaches 1.35 above and below the axis; they stand at 2.1
// and more. Their umbra and penumbra lie in the middle of the wall.
probe::RenderQuestion drawLitQuestion(std::uint64_t seed, int threads) {
    Draw draw{seed, 27};
    probe::RenderQuestion question;
    raytracer::SceneDescription& scene = question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const Vector3 foot{0.0, 0.0, draw.between(5.8, 6.2)};
    for (const double side : {1.0, -1.0}) {
        const double turn = draw.between(-0.5, 0.5);
        const Vector3 aside{side * std::sin(turn), side * std::cos(turn), 0.0};
        const Vector3 target = foot + aside * draw.between(0.2, 0.6);
        const Vector3 nearer{0.0, 0.0, draw.between(1.3, 1.7)};
        const Vector3 light = aside * draw.between(4.3, 4.7) + nearer;
        const Vector3 ball = target + (light - target) * draw.between(0.48, 0.52);
        scene.pointLights.push_back(drawLight(draw, light, (light - foot).magnitude()));
        scene.spheres.push_back({ball, draw.between(0.3, 0.4), drawMaterial(draw), nullptr});
    }
    raytracer::Material wall = drawMaterial(draw);
    wall.reflectivity = 0.0;
    const Vector3 normal = draw.directionAround({0.0, 0.0, -1.0}, 0.15);
    scene.planes.push_back({foot, normal, wall});
    question.settings.width = kLitWidth;
    question.settings.height = kLitHeight;
    question.settings.threads = threads;
    question.settings.seed = draw.word() >> 1U;
    const auto rays =
        static_cast<std::size_t>(kLitWidth * kLitHeight * question.settings.dofRayCount);
    question.eventCapacity = static_cast<std::uint32_t>(rays * kLitEventsForEachRay);
    return question;
}

}  // namespace ticker::tasks
