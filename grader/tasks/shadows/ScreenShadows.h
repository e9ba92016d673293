#ifndef TICKER_TASKS_SHADOWS_SCREENSHADOWS_H
#define TICKER_TASKS_SHADOWS_SCREENSHADOWS_H

#include <grader/exercise/Screening.h>

#include <cstdint>

namespace ticker::tasks {

/// Rays under one light, and colours under one light, several lights and a light before an object:
/// whether they fit an accepted reading.
[[nodiscard]] Screening screenShadows(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
