#ifndef TICKER_TASKS_LENS_SCREENLENS_H
#define TICKER_TASKS_LENS_SCREENLENS_H

#include <grader/exercise/Screening.h>

#include <cstdint>

namespace ticker::tasks {

/// One tiny render of T2.2, judged like the judge's first one.
[[nodiscard]] Screening screenLens(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
