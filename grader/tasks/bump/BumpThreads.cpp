#include <grader/tasks/bump/BumpThreads.h>

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/support/ThreadPictures.h>

#include <raytracer/scene/SceneDescription.h>

#include <cmath>
#include <memory>
#include <utility>

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

/// Whether two channels differ by rounding at most. Two NaNs are equal: a normal that is NaN at
/// some point is so with any number of threads.
bool isSameChannel(double one, double other) {
    constexpr double kRounding = 1e-6;
    if (one == other || (std::isnan(one) && std::isnan(other))) return true;
    return std::abs(one - other) <= kRounding;
}

bool isSameColour(const raytracer::ColourRGB& one, const raytracer::ColourRGB& other) {
    return isSameChannel(one.r, other.r) && isSameChannel(one.g, other.g) &&
           isSameChannel(one.b, other.b);
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
    std::vector<probe::Question> questions;
    addWithOneThreadAndWithTwo(questions, std::move(question));
    return questions;
}

std::size_t pixelsThatThreadsChange(const probe::Run& run, std::size_t first) {
    const auto pictures = threadPicturesAt(run, first, kThreadedPictures);
    return pictures ? pictures->differing(isSameColour) : 0;
}

}  // namespace ticker::tasks::bump
