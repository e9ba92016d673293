#ifndef TICKER_TASKS_BUMP_BUMPTHREADS_H
#define TICKER_TASKS_BUMP_BUMPTHREADS_H

#include <grader/probe/Examinee.h>
#include <grader/probe/Question.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks::bump {

// The pictures with one thread, and as many with two: their size in pixels, and their number.
inline constexpr int kThreadedWidth = 64;
inline constexpr int kThreadedHeight = 48;
inline constexpr int kLoggedPictures = 3;
inline constexpr int kUnloggedPictures = 1;
inline constexpr int kThreadedPictures = kLoggedPictures + kUnloggedPictures;

/// Two pairs of renders of the same bumpy spheres, the first of a pair with one thread, the second
/// with two. The light that a pixel gets depends on normals alone. Only the first pair has a log,
/// at which threads wait for each other.
[[nodiscard]] std::vector<probe::Question> drawThreadedRenders(std::uint64_t seed);

/// Number of pixels in which the second renders of the pairs differ from the first. A pair counts
/// 0 if one of its pictures is missing; code whose calls share no variable has 0.
/// @param first  Index of the first render among the answers.
[[nodiscard]] std::size_t pixelsThatThreadsChange(const probe::Run& run, std::size_t first);

}  // namespace ticker::tasks::bump

#endif
