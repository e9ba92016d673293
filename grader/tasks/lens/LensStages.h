#ifndef TICKER_TASKS_LENS_LENSSTAGES_H
#define TICKER_TASKS_LENS_LENSSTAGES_H

#include <grader/tasks/support/Stages.h>

namespace ticker::tasks {

// Each asks questions of its own, drawn from `seed` and the number of the stage.

/// Pictures of `render`, where its rays cannot be seen.
[[nodiscard]] Stage judgePicture(probe::Examinee& examinee, std::uint64_t seed,
                                 std::uint64_t stage);
/// `render` with two threads, where all was right with one: they may meet or not.
/// @param mayAntialias  See `LensLog`.
[[nodiscard]] Stage judgeThreads(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                                 std::uint64_t stage);

/// `render` after another picture of the same size, where all was right in a first one.
[[nodiscard]] Stage judgeNext(probe::Examinee& examinee, bool mayAntialias, std::uint64_t seed,
                              std::uint64_t stage);

}  // namespace ticker::tasks

#endif
