#ifndef TICKER_TASKS_DISTRIBUTED_PENUMBRAHITS_H
#define TICKER_TASKS_DISTRIBUTED_PENUMBRAHITS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/PenumbraShares.h>

#include <vector>

namespace ticker::tasks {

/// Whether the means are those of code that takes a ray's part of the light away for each sphere
/// that it hits: for the occluder, and again for the one in it. For words only.
[[nodiscard]] bool countsEveryHit(const probe::IlluminateQuestion& asked,
                                  const std::vector<PenumbraSamples>& seen);
[[nodiscard]] Finding everyHitCounts();

}  // namespace ticker::tasks

#endif
