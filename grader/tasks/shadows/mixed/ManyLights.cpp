#include <grader/tasks/shadows/mixed/ClearLights.h>
#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Deck.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace ticker::tasks {

std::vector<ShadowQuestion> drawVeryFarLights(Draw& draw) {
    constexpr int kPoints = 3;
    std::vector<ShadowQuestion> questions;
    for (const Between& away :
         {Between{200.0, 900.0}, Between{1100.0, 3000.0}, Between{6000.0, 9000.0}}) {
        ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::mixed);
        raytracer::SceneDescription& scene = drawn.question.scene;
        scene.ambientLighting = draw.colour(0.1, 0.5);
        addLightTowards(draw, drawn, draw.directionAround(scene.planes.front().normal, 1.2),
                        away.number(draw));
        addLitPoints(draw, drawn, kPoints, 0.1);
        questions.push_back(std::move(drawn));
    }
    return questions;
}

std::vector<ShadowQuestion> drawManyLights(Draw& draw) {
    constexpr std::size_t kLights = 34;
    constexpr std::size_t kDim = 26;  // the last ones are brighter, so that each of them shows
    constexpr double kDimShare = 0.1;
    constexpr int kPoints = 3;
    ShadowQuestion drawn = onFloor(draw, ShadowQuestion::Purpose::mixed);
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.5);
    const Vector3 foot = scene.planes.front().point;
    const Vector3 up = scene.planes.front().normal;
    while (scene.pointLights.size() < kLights) {
        const double share = scene.pointLights.size() < kDim ? kDimShare : 1.0;
        addLightTowards(draw, drawn, draw.directionAround(up, 1.25), draw.between(20.0, 45.0),
                        share);
        const raytracer::PointLight& added = scene.pointLights.back();
        const bool isClear =
            std::all_of(scene.pointLights.begin(), scene.pointLights.end() - 1,
                        [&](const raytracer::PointLight& other) {
                            return areApart(added, other, foot, drawn.question.settings.lightSize);
                        });
        if (!isClear) scene.pointLights.pop_back();
    }
    addLitPoints(draw, drawn, kPoints, 0.1);
    return {std::move(drawn)};
}

}  // namespace ticker::tasks
