#include <grader/tasks/bump/BumpThreads.h>

#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/support/ThreadPictures.h>

#include <raytracer/scene/SceneDescription.h>

#include <cmath>
#include <memory>
#include <utility>
#include <variant>

namespace ticker::tasks::bump {
namespace {

constexpr std::size_t kRendersOfAPair = 2;

std::shared_ptr<const raytracer::HeightMap> drawMap(Draws& draws) {
    // Code that keeps one map's slopes computes 8192 of them at each change of the map: that takes
    // longer than all else, so that a thread is interrupted there, or meets the other there.
    constexpr int kColumns = 128;
    constexpr int kRows = 64;
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < kColumns * kRows; ++i)
        bytes.push_back(static_cast<std::uint8_t>(draws.integer(0, 255)));
    return std::make_shared<const raytracer::HeightMap>(
        raytracer::HeightMap::fromBytes(kColumns, kRows, bytes));
}

/// Three mirrors before the eye, and a large sphere behind it that they show: many pixels need the
/// normals of two maps, so that what is kept of one map changes within a pixel.
raytracer::SceneDescription drawBumpySpheres(Draws& draws) {
    raytracer::SceneDescription scene;
    scene.pointLights.emplace_back(Vector3{draws.uniform(-2.0, 2.0), 3.0, -2.0},
                                   raytracer::ColourRGB{1.0}, 1200.0);
    for (const double x : {-2.0, 0.0, 2.0}) {
        raytracer::Material material;
        material.colour = {draws.uniform(0.4, 0.9), draws.uniform(0.4, 0.9), 0.5};
        material.reflectivity = 0.5;
        scene.spheres.push_back(
            {{x, draws.uniform(-0.3, 0.3), 5.0}, 1.1, material, drawMap(draws)});
    }
    scene.spheres.push_back({{0.0, 0.0, -44.0}, 40.0, {}, drawMap(draws)});
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
    question.settings.bounces = 1;
    question.repetitions = kLoggedPictures;
    std::vector<probe::Question> questions;
    addWithOneThreadAndWithTwo(questions, question);
    question.repetitions = kUnloggedPictures;
    addWithOneThreadAndWithTwo(questions, std::move(question));
    // At the log threads give way between pixels. Where they share a processor, as on a busy
    // machine, that leaves little reason to interrupt one inside of getNormalAt.
    for (std::size_t i = kRendersOfAPair; i < questions.size(); ++i)
        std::get<probe::RenderQuestion>(questions[i]).eventCapacity = 0;
    return questions;
}

std::size_t pixelsThatThreadsChange(const probe::Run& run, std::size_t first) {
    const auto logged = threadPicturesAt(run, first, kLoggedPictures);
    const auto unlogged = threadPicturesAt(run, first + kRendersOfAPair, kUnloggedPictures);
    return (logged ? logged->differing(isSameColour) : 0) +
           (unlogged ? unlogged->differing(isSameColour) : 0);
}

}  // namespace ticker::tasks::bump
