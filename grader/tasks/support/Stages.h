#ifndef TICKER_TASKS_DISTRIBUTED_STAGES_H
#define TICKER_TASKS_DISTRIBUTED_STAGES_H

#include <grader/tasks/shadows/answers/ShadowReplay.h>
#include <grader/probe/Examinee.h>
#include <grader/result/Finding.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// What one round of questions says whose answers are not exact: chance has a part in them.
struct Stage {
    std::optional<Finding> failure;             ///< held against the submission if it comes twice
    std::optional<Finding> doubt;               ///< a warning: a person has to look, and why
    std::optional<double> apertureFactor = {};  ///< of a picture: the accepted one that fits best
};

/// Each asks questions of its own, drawn from `seed` and the number of the stage.
/// The values of `illuminate` at shadows' edges, where its rays cannot be seen.
[[nodiscard]] Stage judgePenumbra(probe::Examinee& examinee, std::uint64_t seed,
                                  std::uint64_t stage);
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

/// `illuminate` inside of `render`: with one thread it does what it did at single points, else a
/// person has to look; with two it still does, or fails.
[[nodiscard]] Stage judgeLitRender(probe::Examinee& examinee, std::uint64_t seed,
                                   std::uint64_t stage);

/// Asks once, and again on other questions where that failed: a failure that does not come again is
/// none, but a person should look.
/// @param judge  Judges the stage of a number, 1 or 2.
/// @return  Whether a person has to look; the reason is added to `findings`, or the failure.
[[nodiscard]] bool keepRepeated(std::vector<Finding>& findings,
                                const std::function<Stage(std::uint64_t)>& judge);

}  // namespace ticker::tasks

#endif
