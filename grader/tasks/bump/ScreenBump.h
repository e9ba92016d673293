#ifndef TICKER_TASKS_BUMP_SCREENBUMP_H
#define TICKER_TASKS_BUMP_SCREENBUMP_H

#include <grader/exercise/Screening.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Small ramps along u and along v, to see whether the normals lean the right way.
[[nodiscard]] Screening screenBump(std::uint64_t seed);

/// The same ramps, each time with another part of the examination: equal points in another order,
/// steep slopes, the map's edges, the poles, maps of few texels. For mistakes that gentle ramps do
/// not show.
[[nodiscard]] std::vector<Screening> screenBumpElsewhere(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
