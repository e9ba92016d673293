#include <grader/tasks/bump/BumpThreads.h>

#include <grader/tasks/bump/questions/Draws.h>

#include <raytracer/scene/SceneDescription.h>

#include <cmath>
#include <memory>
#include <variant>

namespace ticker::tasks::bump {
namespace {

std::shared_ptr<const raytracer::HeightMap> drawMap(Draws& draws) {
    constexpr int kSide = 32;
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < kSide * kSide; ++i)
        bytes.push_back(static_cast<std::uint8_t>(draws.integer(0, 255)));
    return std::make_shared<const raytracer::HeightMap>(
        raytracer::HeightMap::fromBytes(kSide, kSide, bytes));
}

raytracer::SceneDescription drawBumpySpheres(Draws& draws) {
    raytracer::SceneDescription scene;
    scene.pointLights.emplace_back(Vector3{draws.uniform(-2.0, 2.0), 3.0, -2.0},
                                   raytracer::ColourRGB{1.0}, 1200.0);
    for (const double x : {-2.0, 0.0, 2.0}) {
        raytracer::Material material;
        material.colour = {draws.uniform(0.4, 0.9), draws.uniform(0.4, 0.9), 0.5};
        scene.spheres.push_back(
            {{x, draws.uniform(-0.3, 0.3), 5.0}, 1.1, material, drawMap(draws)});
    }
    return scene;
}

const probe::RenderAnswer* renderedIn(const probe::Run& run, std::size_t at) {
    if (at >= run.answers.size()) return nullptr;
    const auto* answer = std::get_if<probe::RenderAnswer>(&run.answers[at]);
    const bool isWhole = answer != nullptr && answer->state == probe::AnswerState::answered &&
                         answer->images.size() == std::size_t{kThreadedPictures};
    return isWhole ? answer : nullptr;
}

/// Whether two channels differ by more than rounding. Two NaNs are equal: a normal that is NaN at
/// some point is so with any number of threads.
bool differ(double one, double other) {
    constexpr double kRounding = 1e-6;
    if (one == other || (std::isnan(one) && std::isnan(other))) return false;
    return !(std::abs(one - other) <= kRounding);
}

bool differ(const raytracer::ColourRGB& one, const raytracer::ColourRGB& other) {
    return differ(one.r, other.r) || differ(one.g, other.g) || differ(one.b, other.b);
}

}  // namespace

std::vector<probe::Question> drawThreadedRenders(std::uint64_t seed) {
    Draws draws(seed);
    probe::RenderQuestion question;
    question.scene = drawBumpySpheres(draws);
    question.settings.width = kThreadedWidth;
    question.settings.height = kThreadedHeight;
    question.settings.bounces = 0;
    question.repetitions = kThreadedPictures;
    question.eventCapacity = 64;  // the log makes threads wait for each other
    std::vector<probe::Question> questions;
    for (const int threads : {1, 2}) {
        question.settings.threads = threads;
        questions.emplace_back(question);
    }
    return questions;
}

std::size_t pixelsThatThreadsChange(const probe::Run& run, std::size_t first) {
    const probe::RenderAnswer* alone = renderedIn(run, first);
    const probe::RenderAnswer* together = renderedIn(run, first + 1);
    if (alone == nullptr || together == nullptr) return 0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < alone->images.size(); ++k)
        for (std::size_t i = 0; i < alone->images[k].size(); ++i)
            if (differ(alone->images[k][i], together->images[k].at(i))) ++count;
    return count;
}

}  // namespace ticker::tasks::bump
