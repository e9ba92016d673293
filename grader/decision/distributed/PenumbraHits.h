#ifndef TICKER_DECISION_DISTRIBUTED_PENUMBRAHITS_H
#define TICKER_DECISION_DISTRIBUTED_PENUMBRAHITS_H

#include <grader/decision/distributed/PenumbraShares.h>
#include <grader/result/Finding.h>

#include <vector>

namespace ticker::decision {

/// Whether the means are those of code that takes a ray's part of the light away for each sphere
/// that it hits: for the occluder, and again for the one in it. For words only.
[[nodiscard]] bool countsEveryHit(const probe::IlluminateQuestion& asked,
                                  const std::vector<PenumbraSamples>& seen);
[[nodiscard]] Finding everyHitCounts();

}  // namespace ticker::decision

#endif
