#include <grader/tasks/screenshot/Repetition.h>

#include <grader/tasks/screenshot/Agreement.h>
#include <grader/tasks/screenshot/Windows.h>

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

using Renders = std::vector<std::vector<raytracer::ColourRGB>>;

// Linear colours, because bytes hide small differences; empty if some are missing.
Renders rendersOf(const Scene& scene, const std::vector<probe::Question>& questions) {
    const probe::Run run = scene.examinee->ask(questions);
    Renders renders;
    for (const probe::Answer& any : run.answers) {
        const auto* answer = std::get_if<probe::RenderAnswer>(&any);
        if (answer == nullptr || answer->state != probe::AnswerState::answered ||
            answer->wrongSize || answer->images.size() != 1)
            return {};
        renders.push_back(answer->images.front());
    }
    return renders;
}

bool repeatsWithThreads(const Scene& scene, const Windows& windows, std::uint64_t seed) {
    constexpr int kTimes = 2;  // a data race may not show at the first time
    const Renders expected = rendersOf(scene, questionsFor(scene, windows, seed));
    std::vector<probe::Question> backwards = questionsFor(scene, windows, seed, 2);
    std::ranges::reverse(backwards);
    for (int i = 0; i < kTimes; ++i) {
        Renders again = rendersOf(scene, backwards);
        std::ranges::reverse(again);
        if (expected.empty() || again != expected) return false;
    }
    return true;
}

// A pattern of points that all pixels share changes pictures as a whole. Each comparison finds a
// false difference with a chance below 5e-4; the picture then passes.
bool repeatsUnderSeeds(const Scene& scene, const Windows& windows, std::uint64_t seed) {
    constexpr std::uint64_t kSeeds = 3;
    const std::optional<Picture> first = renderWindows(scene, windows, seed);
    for (std::uint64_t i = 1; i <= kSeeds; ++i) {
        const std::optional<Picture> other = renderWindows(scene, windows, seed + i);
        if (!first || !other || !agreementOf(other->view(), first->view(), scene.isRandom).agrees)
            return false;
    }
    return true;
}

// One whole frame, for code that ignores regions.
Windows wholeFrame() {
    constexpr int kWidth = 160;
    constexpr int kHeight = 120;
    return {kWidth, kHeight, {{0, 0, 0, 0}}};
}

}  // namespace

std::string whyNotRepeated(const Scene& scene, int width, int height, std::uint64_t seed) {
    if (scene.examinee == nullptr) return {};
    if (!scene.whyUnlikeItself.empty()) return scene.whyUnlikeItself;
    const Windows parts = drawWindows(!scene.isRandom, width, height, seed);
    const bool rendersParts = !rendersOf(scene, questionsFor(scene, parts, seed)).empty();
    const Windows windows = rendersParts ? parts : wholeFrame();
    if (!repeatsWithThreads(scene, windows, seed))
        return "this code does not draw the same picture again under the same seed, or not with "
               "two threads";
    if (rendersParts && !repeatsUnderSeeds(scene, windows, seed))
        return "this code's own pictures differ as much from one to the next";
    return {};
}

}  // namespace ticker::tasks::screenshot
