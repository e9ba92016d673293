#include <grader/tasks/maintick/Exact.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/ThreadPictures.h>

#include <fmt/core.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

// On a busy machine the threads of one picture may hardly meet.
constexpr int kPictures = 4;

raytracer::Material drawMaterial(Draw& draw, double reflectivity) {
    raytracer::Material material;
    material.colour = draw.colour(0.3, 0.9);
    material.reflectivity = reflectivity;
    return material;
}

raytracer::SceneDescription drawRoom(Draw& draw, Shows shows) {
    const double share = shows == Shows::mirrors ? 0.5 : 0.0;
    raytracer::SceneDescription scene;
    scene.ambientLighting = draw.colour(0.03, 0.1);
    // One light is near and one is far: a vector to one that is used for the other then shows.
    const ColourRGB near = draw.colour(0.5, 1.0);
    scene.pointLights.emplace_back(Vector3{draw.between(-0.5, 0.5), -0.4, 3.8}, near, 8.0);
    const ColourRGB far = draw.colour(0.5, 1.0);
    scene.pointLights.emplace_back(Vector3{draw.between(0.5, 1.5), 9.0, 2.5}, far, 1500.0);
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, drawMaterial(draw, share)});
    if (shows == Shows::floor) return scene;  // no shadow ray meets anything
    scene.planes.push_back({{0.0, 0.0, 6.0}, {0.0, 0.0, -1.0}, drawMaterial(draw, share)});
    for (const double x : {-0.9, 0.0, 0.9})
        scene.spheres.push_back(
            {{x, draw.between(-0.3, 0.3), 4.5}, 0.4, drawMaterial(draw, share), nullptr});
    return scene;
}

probe::RenderQuestion renderOf(const raytracer::SceneDescription& scene) {
    probe::RenderQuestion question;
    question.scene = scene;
    question.settings.width = 16;
    question.settings.height = 12;
    question.repetitions = kPictures;
    return question;
}

/// How many pixels differ; empty if a picture is missing.
std::optional<std::size_t> differing(const probe::Run& run, std::size_t question) {
    const auto pictures = threadPicturesAt(run, question, kPictures);
    if (!pictures) return std::nullopt;
    return pictures->differing(
        [](const ColourRGB& alone, const ColourRGB& together) { return isNear(together, alone); });
}

}  // namespace

std::optional<Finding> checkThreads(probe::Examinee& examinee, std::uint64_t seed, Shows shows,
                                    const FindingText& text) {
    Draw draw{seed, 107};
    std::vector<probe::Question> questions;
    for (const Shows each : {Shows::floor, Shows::shadows, Shows::mirrors}) {
        if (each > shows) break;
        addWithOneThreadAndWithTwo(questions, renderOf(drawRoom(draw, each)));
    }
    const probe::Run run = examinee.ask(questions);
    for (std::size_t i = 0; i + 2 < questions.size(); i += 2)
        if (differing(run, i) != 0) return std::nullopt;
    const std::optional<std::size_t> count = differing(run, questions.size() - 2);
    if (!count || *count == 0) return std::nullopt;
    return failure(
        text,
        fmt::format("{} pictures of 16 x 12 pixels were rendered with one thread and with two, and "
                    "forEachPixel has as many as the machine has cores: {} pixels differ.",
                    kPictures, *count));
}

}  // namespace ticker::tasks::maintick
