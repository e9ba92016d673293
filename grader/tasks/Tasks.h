#ifndef TICKER_TASKS_TASKS_H
#define TICKER_TASKS_TASKS_H

#include <grader/exercise/Exercise.h>
#include <grader/exercise/Task.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ticker::tasks {

/// The code of all tasks of an exercise, by its name; empty for an unknown name. A task is
/// registered here only.
[[nodiscard]] std::span<const Task> tasksOf(std::string_view exercise);

/// Judges the tasks of a file, one after the other, for the lab and for tests: as a grading does,
/// but without a build, a render or a doubt.
/// @param only  The id of the one task to judge; empty: each of the file.
[[nodiscard]] std::vector<TaskReport> judgeFile(const Exercise& exercise, std::string_view file,
                                                probe::Examinee& examinee, std::uint64_t seed,
                                                std::string_view only = {});

}  // namespace ticker::tasks

#endif
