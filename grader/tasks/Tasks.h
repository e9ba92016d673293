#ifndef TICKER_TASKS_TASKS_H
#define TICKER_TASKS_TASKS_H

#include <grader/exercise/Task.h>

#include <span>
#include <string_view>

namespace ticker::tasks {

/// The code of all tasks of an exercise, by its name; empty if there is none. A task is registered
/// here only.
[[nodiscard]] std::span<const Task> tasksOf(std::string_view exercise);

}  // namespace ticker::tasks

#endif
