#ifndef TICKER_TASKS_BUMP_BUMPTHREADS_H
#define TICKER_TASKS_BUMP_BUMPTHREADS_H

#include <grader/probe/Examinee.h>
#include <grader/probe/Question.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks::bump {

// The pictures of each render: their size in pixels, and their number.
inline constexpr int kThreadedWidth = 64;
inline constexpr int kThreadedHeight = 48;
inline constexpr int kThreadedPictures = 3;

/// Two renders of the same bumpy spheres, the first with one thread, the second with two. The light
/// that a pixel gets depends on its normal alone.
[[nodiscard]] std::vector<probe::Question> drawThreadedRenders(std::uint64_t seed);

/// Number of pixels in which the second of these renders differs from the first. It is 0 for code
/// whose calls share no variable, and if a picture is missing.
/// @param first  Index of the first render among the answers.
[[nodiscard]] std::size_t pixelsThatThreadsChange(const probe::Run& run, std::size_t first);

}  // namespace ticker::tasks::bump

#endif
