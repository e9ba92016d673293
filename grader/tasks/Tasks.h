#ifndef TICKER_TASKS_TASKS_H
#define TICKER_TASKS_TASKS_H

#include <grader/exercise/Task.h>

#include <span>

namespace ticker::tasks {

/// The code of every task that an exercise's file may name: the one registration.
[[nodiscard]] std::span<const Task> theTasks();

}  // namespace ticker::tasks

#endif
