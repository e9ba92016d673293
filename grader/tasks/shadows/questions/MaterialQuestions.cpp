#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Draw.h>

#include <vector>

namespace ticker::tasks {
namespace {

using raytracer::Material;

constexpr int kPointsOfMaterial = 4;

/// A floor of this material under a light.
ShadowQuestion litFloor(Draw& draw, ShadowQuestion::Purpose purpose,
                        void (*change)(Material& material)) {
    ShadowQuestion drawn = onFloor(draw, purpose);
    raytracer::SceneDescription& scene = drawn.question.scene;
    scene.ambientLighting = draw.colour(0.1, 0.2);
    change(scene.planes.front().material);
    const Vector3 towards = draw.directionAround(scene.planes.front().normal, 0.6);
    addLightTowards(draw, drawn, towards, draw.between(5.0, 8.0));
    addLitPoints(draw, drawn, kPointsOfMaterial, 0.5);
    return drawn;
}

/// The light has green alone, and the surface reflects none of it.
ShadowQuestion otherColour(Draw& draw) {
    ShadowQuestion drawn = litFloor(draw, ShadowQuestion::Purpose::oneTerm,
                                    [](Material& material) { material.colour.g = 0.0; });
    raytracer::PointLight& light = drawn.question.scene.pointLights.front();
    light = {light.position(), ColourRGB{0.0, draw.between(0.7, 0.9), 0.0}, light.intensity()};
    return drawn;
}

}  // namespace

std::vector<ShadowQuestion> drawMaterials(Draw& draw) {
    using enum ShadowQuestion::Purpose;
    return {
        litFloor(draw, oneTerm, [](Material& material) { material.colour = ColourRGB{0.0}; }),
        litFloor(draw, oneTerm, [](Material& material) { material.phongKD = 0.0; }),
        litFloor(draw, oneTerm, [](Material& material) { material.phongKS = 0.0; }),
        otherColour(draw),
        litFloor(draw, mirror, [](Material& material) { material.reflectivity = 1.0; }),
    };
}

}  // namespace ticker::tasks
