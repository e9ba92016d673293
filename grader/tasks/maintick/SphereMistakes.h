#ifndef TICKER_TASKS_MAINTICK_SPHEREMISTAKES_H
#define TICKER_TASKS_MAINTICK_SPHEREMISTAKES_H

#include <grader/tasks/maintick/Hits.h>

#include <span>

namespace ticker::tasks::maintick {

/// The known mistakes in the distance to a sphere, in the order in which the first that explains
/// everything is named.
[[nodiscard]] std::span<const HitMistake> sphereMistakes();

}  // namespace ticker::tasks::maintick

#endif
