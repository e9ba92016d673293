#ifndef TICKER_TASKS_TASKS_H
#define TICKER_TASKS_TASKS_H

#include <grader/exercise/Task.h>

#include <span>

namespace ticker::tasks {

/// The code of all tasks that an exercise may name. A task is registered here only.
[[nodiscard]] std::span<const Task> theTasks();

}  // namespace ticker::tasks

#endif
