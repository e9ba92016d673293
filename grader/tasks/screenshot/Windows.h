#ifndef TICKER_TASKS_SCREENSHOT_WINDOWS_H
#define TICKER_TASKS_SCREENSHOT_WINDOWS_H

#include <grader/metrics/Alignment.h>
#include <grader/probe/Question.h>
#include <grader/tasks/screenshot/Scene.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::tasks::screenshot {

/// The smallest picture that is judged: below, windows would overlap.
inline constexpr int kSmallestWidth = 320;
/// A window may be looked for this far away, pixels.
inline constexpr int kFarthestShift = 3;

/// True for pictures of the handout's shape, 4 : 3 but for rounding, from 320 x 240 pixels.
[[nodiscard]] bool isSensibleSize(int width, int height);

/// A few small parts of a frame, all of one size, none touching another or the frame's edge.
struct Windows {
    int frameWidth = 0;
    int frameHeight = 0;
    std::vector<metrics::Box> boxes;
};

/// About 2000 pixels where mistakes show: the rims of shadows and of blurred balls, lit relief. A
/// little off from seed to seed, so that nobody knows them before. Another stage, other pixels.
/// @param stage  0 or 1.
[[nodiscard]] Windows drawWindows(bool isDeterministic, int width, int height, std::uint64_t seed,
                                  int stage = 0);

/// The windows of a picture, one below the other.
/// @param picture  As large as the windows' frame.
/// @param right, down  Where to look instead, pixels, at most `kFarthestShift`.
[[nodiscard]] Picture cutOut(const ByteView& picture, const Windows& windows, int right = 0,
                             int down = 0);

/// The questions that render the windows with a submission's code, at the handout's settings.
/// @param threads  Of `forEachPixel`.
[[nodiscard]] std::vector<probe::Question> questionsFor(const Scene& scene, const Windows& windows,
                                                        std::uint64_t seed, int threads = 1);

/// What a submission's code made of windows.
struct OwnRender {
    std::optional<Picture> windows;  ///< one below the other; empty where some of it is missing
    probe::ProcessEnd end;
};

/// The windows as a submission's code renders them, at the handout's settings, through the tone
/// curve. Code that knows nothing of regions gives none.
/// @param scene  With an examinee.
[[nodiscard]] OwnRender askForWindows(const Scene& scene, const Windows& windows,
                                      std::uint64_t seed);

/// The same, where it does not matter why there is none.
[[nodiscard]] std::optional<Picture> renderWindows(const Scene& scene, const Windows& windows,
                                                   std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
