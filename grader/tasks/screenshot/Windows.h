#ifndef TICKER_TASKS_SCREENSHOT_WINDOWS_H
#define TICKER_TASKS_SCREENSHOT_WINDOWS_H

#include <grader/metrics/Alignment.h>
#include <grader/probe/Question.h>
#include <grader/tasks/screenshot/ShownScene.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::tasks::screenshot {

/// Width of the smallest picture that is judged: in smaller ones windows would overlap.
inline constexpr int kSmallestWidth = 320;
/// Largest displacement at which windows are searched for, pixels.
inline constexpr int kFarthestShift = 3;

/// True for pictures of the handout's shape, 4 : 3 but for rounding, from 320 x 240 pixels to the
/// largest frame of a question.
[[nodiscard]] bool isSensibleSize(int width, int height);

/// A few small parts of a frame, all of one size; none touches another or the frame's edge.
struct Windows {
    int frameWidth = 0;
    int frameHeight = 0;
    std::vector<metrics::Box> boxes;
};

/// 2000 to 3500 pixels that show mistakes: penumbras, edges of blurred balls, lit relief. Their
/// places vary a little with the seed, so that they are not known in advance. With random rays the
/// two stages use different pixels.
/// @param stage  0 or 1.
[[nodiscard]] Windows drawWindows(bool isDeterministic, int width, int height, std::uint64_t seed,
                                  int stage = 0);

/// The windows of a picture, one below the other.
/// @param picture  As large as the windows' frame.
/// @param right, down  Displacement of the windows, pixels, at most `kFarthestShift`.
[[nodiscard]] Picture cutOut(const ByteView& picture, const Windows& windows, int right = 0,
                             int down = 0);

/// The questions that render the windows with a submission's code, at the handout's settings.
/// @param threads  Number of threads of `forEachPixel`.
[[nodiscard]] std::vector<probe::Question> questionsFor(const Scene& scene, const Windows& windows,
                                                        std::uint64_t seed, int threads = 1);

/// The first questions of `judgeScreenshot` about a picture of this size and scene.
/// @param seed  As for `judgeScreenshot`.
[[nodiscard]] std::vector<probe::Question> firstQuestions(
    const raytracer::SceneDescription& description, bool isRandom, int width, int height,
    std::uint64_t seed);

/// True if the answer holds one image with every pixel.
[[nodiscard]] bool isWhole(const probe::RenderAnswer& answer);

/// A submission's render of windows.
struct OwnRender {
    std::optional<Picture> windows;  ///< one below the other; empty if a part is missing
    probe::ProcessEnd end;
};

/// The windows rendered by a submission's code, at the handout's settings, with the tone curve.
/// Code that ignores regions renders none.
/// @param scene  Must have an examinee.
[[nodiscard]] OwnRender askForWindows(const Scene& scene, const Windows& windows,
                                      std::uint64_t seed);

/// The same without the reason of a failure.
[[nodiscard]] std::optional<Picture> renderWindows(const Scene& scene, const Windows& windows,
                                                   std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
