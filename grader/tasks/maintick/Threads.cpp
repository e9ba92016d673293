#include <grader/tasks/maintick/Exact.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/support/Draw.h>

#include <fmt/core.h>

#include <variant>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

using probe::RenderAnswer;
using probe::RenderQuestion;

// On a busy machine the threads of one picture may hardly meet.
constexpr std::size_t kPictures = 4;

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

RenderQuestion renderOf(const raytracer::SceneDescription& scene, int threads) {
    RenderQuestion question;
    question.scene = scene;
    question.settings.width = 16;
    question.settings.height = 12;
    question.settings.threads = threads;
    question.repetitions = static_cast<int>(kPictures);
    question.eventCapacity = 64;  // the log makes threads wait for each other
    return question;
}

const RenderAnswer* picturesOf(const probe::Run& run, std::size_t question) {
    if (question >= run.answers.size()) return nullptr;
    const auto* answer = std::get_if<RenderAnswer>(&run.answers[question]);
    const bool isRendered = answer != nullptr && answer->state == probe::AnswerState::answered &&
                            !answer->wrongSize && answer->images.size() == kPictures;
    return isRendered ? answer : nullptr;
}

/// How many pixels differ; empty if a picture is missing.
std::optional<int> differing(const probe::Run& run, std::size_t question) {
    const auto* alone = picturesOf(run, question);
    const auto* together = picturesOf(run, question + 1);
    if (alone == nullptr || together == nullptr) return {};
    int count = 0;
    for (std::size_t k = 0; k < kPictures; ++k)
        for (std::size_t i = 0; i < alone->images[k].size(); ++i)
            if (!isNear(together->images[k].at(i), alone->images[k][i])) ++count;
    return count;
}

}  // namespace

std::optional<Finding> checkThreads(probe::Examinee& examinee, std::uint64_t seed, Shows shows,
                                    const FindingText& text) {
    Draw draw{seed, 107};
    std::vector<probe::Question> questions;
    for (const Shows each : {Shows::floor, Shows::shadows, Shows::mirrors}) {
        if (each > shows) break;
        const raytracer::SceneDescription scene = drawRoom(draw, each);
        for (const int threads : {1, 2})
            questions.emplace_back(renderOf(scene, threads));
    }
    const probe::Run run = examinee.ask(questions);
    for (std::size_t i = 0; i + 2 < questions.size(); i += 2)
        if (differing(run, i) != 0) return std::nullopt;
    const std::optional<int> count = differing(run, questions.size() - 2);
    if (!count || *count == 0) return std::nullopt;
    return failure(
        text,
        fmt::format("{} pictures of 16 x 12 pixels were rendered with one thread and with two, and "
                    "forEachPixel has as many as the machine has cores: {} pixels differ.",
                    kPictures, *count));
}

}  // namespace ticker::tasks::maintick
