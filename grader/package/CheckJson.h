#ifndef TICKER_PACKAGE_CHECKJSON_H
#define TICKER_PACKAGE_CHECKJSON_H

#include <grader/exercise/Exercise.h>

#include <string>

namespace ticker::package {

/// check.json of a students' package, with every task of the exercise: ./check mentions only the
/// tasks that it lists. A task that `text` lacks is added to its option, and an option of which
/// `text` has no task is added with its files. Neither has public tests.
/// @param text  Of the template's check.json, or of the overlay's.
/// @return  `text` itself if it lacks nothing.
[[nodiscard]] std::string withEveryTask(const std::string& text, const Exercise& exercise);

}  // namespace ticker::package

#endif
