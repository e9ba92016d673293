#include <grader/decision/distributed/Draw.h>
#include <grader/decision/distributed/LensQuestions.h>

#include <cstddef>

namespace ticker::decision {
namespace {

// 6 x 4 pixels, two repetitions, 50 rays: 2400 lens points.
constexpr int kWidth = 6;
constexpr int kHeight = 4;
constexpr int kRepetitions = 2;
constexpr int kSpheres = 24;

// Events of one lens ray: trace and illuminate begin and end, one ray cast; the camera's ray and
// the pixel come on top. Four times as many have room.
constexpr std::size_t kEventsForEachRay = 24;

// Spheres of many colours at all depths, so that neighbouring rays see different things.
raytracer::SceneDescription drawScene(Draw& draw) {
    raytracer::SceneDescription scene;
    // Colours of more and of less than 1, so that it shows where one is cut off.
    scene.ambientLighting = draw.colour(2.0, 4.0);
    for (int i = 0; i < kSpheres; ++i) {
        raytracer::Material material;
        material.colour = draw.colour(0.05, 1.0);
        material.reflectivity = 0.0;
        const double z = draw.between(1.8, 8.0);
        const double x = draw.between(-0.42, 0.42) * z;
        const Vector3 centre{x, draw.between(-0.3, 0.3) * z, z};
        scene.spheres.push_back({centre, draw.between(0.04, 0.1) * z, material, nullptr});
    }
    // Above the floor some rays hit nothing.
    raytracer::Material floor;
    floor.colour = draw.colour(0.2, 0.8);
    floor.reflectivity = 0.0;
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, floor});
    return scene;
}

probe::RenderQuestion drawQuestion(Draw& draw, const raytracer::RenderSettings& settings,
                                   int repetitions) {
    probe::RenderQuestion question;
    question.scene = drawScene(draw);
    question.settings = settings;
    question.settings.seed = draw.word() >> 1U;
    question.repetitions = repetitions;
    const auto pixels = static_cast<std::size_t>(settings.width * settings.height * repetitions);
    question.eventCapacity = static_cast<std::uint32_t>(
        pixels * static_cast<std::size_t>(settings.dofRayCount) * kEventsForEachRay);
    return question;
}

}  // namespace

LensQuestions drawLensQuestions(std::uint64_t seed) {
    Draw draw{seed, 22};
    raytracer::RenderSettings handout;
    handout.width = kWidth;
    handout.height = kHeight;
    LensQuestions questions;
    questions.handout = drawQuestion(draw, handout, kRepetitions);

    raytracer::RenderSettings other;
    other.width = 4;
    other.height = 3;
    other.dofRayCount = draw.whole(90, 110);
    other.dofFocalPlane = draw.between(4.5, 6.0);
    other.dofAmount = draw.between(0.28, 0.35);
    other.bounces = 1;
    questions.other = drawQuestion(draw, other, 1);
    return questions;
}

}  // namespace ticker::decision
