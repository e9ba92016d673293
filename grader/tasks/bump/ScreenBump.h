#ifndef TICKER_TASKS_BUMP_SCREENBUMP_H
#define TICKER_TASKS_BUMP_SCREENBUMP_H

#include <grader/exercise/Screening.h>

#include <cstdint>

namespace ticker::tasks {

/// Small ramps along u and along v, to see whether the normals lean the right way.
[[nodiscard]] Screening screenBump(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
