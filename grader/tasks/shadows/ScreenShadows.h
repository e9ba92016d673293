#ifndef TICKER_TASKS_SHADOWS_SCREENSHADOWS_H
#define TICKER_TASKS_SHADOWS_SCREENSHADOWS_H

#include <grader/exercise/Screening.h>

#include <cstdint>

namespace ticker::tasks {

/// Rays and colours under one light: does the arithmetic fit an accepted reading?
[[nodiscard]] Screening screenShadows(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
