#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAHITS_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAHITS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>

#include <vector>

namespace ticker::tasks {

/// Whether the means fit code that subtracts a ray's part of the light for each sphere that it
/// hits: for the occluder, and again for the sphere inside it. Used for words only.
[[nodiscard]] bool countsEveryHit(PenumbraExpectations& expectations,
                                  const std::vector<PenumbraSamples>& seen);
[[nodiscard]] Finding everyHitCounts();

}  // namespace ticker::tasks

#endif
