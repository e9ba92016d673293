#include <grader/tasks/screenshot/Windows.h>

#include <grader/probe/AnswerMemory.h>

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <span>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

/// Centre of a window in a frame of 640 x 480 pixels.
struct Middle {
    int x;
    int y;
};
constexpr double kUsualWidth = 640.0;

/// Places of an option's windows.
struct Layout {
    std::array<std::span<const Middle>, 2> middles;  ///< of each stage
    int width;
    int height;
    int jitter;  ///< pixels, in each direction
    int step;    ///< from the first stage's windows to the second's, pixels
};

// Found by a greedy search over 34 pairs of an accepted reading and one with a mistake: the windows
// in which two single renders differ most, in standard errors of their sums. In order: the mirrored
// shadow, three penumbras of the first ball's shadow and its contact with the floor, the second
// ball's shadow, the first ball's highlight, the horizon, the farthest balls.
constexpr Middle kDistributed[] = {{400, 440}, {352, 400}, {576, 384}, {440, 384},
                                   {288, 312}, {456, 224}, {24, 184},  {190, 180}};
// In a narrow picture the same windows have a quarter of the noise's pixels at a penumbra, so they
// are larger and lie closer, with other places for each stage. Found by the same search at 320 x
// 240, over lights and apertures of other sizes and places.
constexpr Middle kNarrowFirst[] = {{376, 408}, {512, 440}, {224, 184},
                                   {544, 360}, {440, 376}, {336, 192}};
constexpr Middle kNarrowSecond[] = {{576, 424}, {280, 304}, {448, 440},
                                    {56, 192},  {584, 184}, {200, 280}};
// Around the highlight, where both lights reach the relief.
constexpr Middle kBumpMapping[] = {{380, 185}};

// Without random rays one window suffices; each costs a transfer of the map.
constexpr Layout kLayoutT1{{kBumpMapping, kBumpMapping}, 64, 40, 6, 12};
constexpr Layout kLayoutT2{{kDistributed, kDistributed}, 16, 16, 4, 25};
constexpr Layout kNarrowLayoutT2{{kNarrowFirst, kNarrowSecond}, 24, 24, 4, 0};
constexpr int kNarrow = 480;

const Layout& layoutFor(bool isDeterministic, int width) {
    if (isDeterministic) return kLayoutT1;
    return width < kNarrow ? kNarrowLayoutT2 : kLayoutT2;
}

int placed(double middle, int size, int frame) {
    const int start = static_cast<int>(std::lround(middle - 0.5 * size));
    return std::clamp(start, kFarthestShift, frame - size - kFarthestShift);
}

raytracer::RenderSettings settingsFor(const Windows& windows, const metrics::Box& box,
                                      std::uint64_t seed) {
    raytracer::RenderSettings settings;
    settings.width = windows.frameWidth;
    settings.height = windows.frameHeight;
    settings.region = {box.x, box.y, box.width, box.height};
    settings.seed = seed;
    return settings;
}

}  // namespace

bool isSensibleSize(int width, int height) {
    constexpr int kRounding =
        4;  // |3 width - 4 height| of a picture that is one pixel too high or too low
    return width >= kSmallestWidth && width <= probe::kLargestFrame &&
           std::abs(3 * width - 4 * height) <= kRounding;
}

Windows drawWindows(bool isDeterministic, int width, int height, std::uint64_t seed, int stage) {
    const Layout& layout = layoutFor(isDeterministic, width);
    std::mt19937_64 generator{seed};
    const auto jitter = [&] {
        return static_cast<int>(generator() % static_cast<std::uint64_t>(2 * layout.jitter + 1)) -
               layout.jitter;
    };
    Windows windows{width, height, {}};
    const double scale = width / kUsualWidth;
    for (const Middle& middle : layout.middles.at(static_cast<std::size_t>(stage))) {
        const double x = scale * middle.x + jitter() + stage * layout.step;
        const double y = scale * middle.y + jitter();
        windows.boxes.push_back({placed(x, layout.width, width), placed(y, layout.height, height),
                                 layout.width, layout.height});
    }
    return windows;
}

Picture cutOut(const ByteView& picture, const Windows& windows, int right, int down) {
    Picture strip{windows.boxes.front().width, 0, {}};
    for (const metrics::Box& box : windows.boxes) {
        const Picture part =
            metrics::cropped(picture, {box.x + right, box.y + down, box.width, box.height});
        strip.height += part.height;
        strip.rgb.insert(strip.rgb.end(), part.rgb.begin(), part.rgb.end());
    }
    return strip;
}

std::vector<probe::Question> questionsFor(const Scene& scene, const Windows& windows,
                                          std::uint64_t seed, int threads) {
    std::vector<probe::Question> questions;
    for (const metrics::Box& box : windows.boxes) {
        raytracer::RenderSettings settings = settingsFor(windows, box, seed);
        settings.threads = threads;
        questions.emplace_back(probe::RenderQuestion{*scene.description, settings, 1, 0});
    }
    return questions;
}

std::vector<probe::Question> firstQuestions(const raytracer::SceneDescription& description,
                                            bool isRandom, int width, int height,
                                            std::uint64_t seed) {
    Scene scene;
    scene.description = &description;
    return questionsFor(scene, drawWindows(!isRandom, width, height, seed), seed);
}

bool isWhole(const probe::RenderAnswer& answer) {
    return answer.state == probe::AnswerState::answered && !answer.wrongSize &&
           answer.images.size() == 1 &&
           std::ranges::none_of(answer.images.front(),
                                [](const auto& pixel) { return probe::isUnanswered(pixel); });
}

OwnRender askForWindows(const Scene& scene, const Windows& windows, std::uint64_t seed) {
    const probe::Run run = scene.examinee->ask(questionsFor(scene, windows, seed));

    Picture strip{windows.boxes.front().width, 0, {}};
    for (const probe::Answer& any : run.answers) {
        const auto* answer = std::get_if<probe::RenderAnswer>(&any);
        if (answer == nullptr || !isWhole(*answer)) return {std::nullopt, run.end};
        for (const raytracer::ColourRGB& colour : answer->images.front())
            for (const std::uint8_t byte : raytracer::toneMapped(colour))
                strip.rgb.push_back(byte);
        strip.height += answer->height;
    }
    return {std::move(strip), run.end};
}

std::optional<Picture> renderWindows(const Scene& scene, const Windows& windows,
                                     std::uint64_t seed) {
    if (scene.examinee == nullptr) return std::nullopt;
    return askForWindows(scene, windows, seed).windows;
}

}  // namespace ticker::tasks::screenshot
