#ifndef TICKER_TASKS_SHADOWS_SHADOWSTAGES_H
#define TICKER_TASKS_SHADOWS_SHADOWSTAGES_H

#include <grader/tasks/support/Stages.h>

namespace ticker::tasks {

// Each asks questions of its own, drawn from `seed` and the number of the stage.

/// The values of `illuminate` at shadows' edges, where its rays cannot be seen.
[[nodiscard]] Stage judgePenumbra(probe::Examinee& examinee, std::uint64_t seed,
                                  std::uint64_t stage);
/// `illuminate` inside of `render`: with one thread it does what it did at single points, else a
/// person has to look; with two it still does, or fails.
[[nodiscard]] Stage judgeLitRender(probe::Examinee& examinee, std::uint64_t seed,
                                   std::uint64_t stage);

}  // namespace ticker::tasks

#endif
