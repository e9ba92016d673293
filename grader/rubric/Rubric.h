#ifndef TICKER_RUBRIC_RUBRIC_H
#define TICKER_RUBRIC_RUBRIC_H

#include <grader/exercise/Exercise.h>
#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ticker::rubric {

/// What earns the tick, as data; see rubric.schema.json.
struct Rubric {
    double maxScore = 1.0;
    std::vector<Option> options;
    std::string screenshotTask;                  ///< empty: screenshots do not matter
    std::map<std::string, Severity> severities;  ///< finding id -> severity of this course
};

/// Reads a rubric file.
/// @throws raytracer::InputError naming the file, the line, the member and what was expected: also
///         for a finding that does not exist.
[[nodiscard]] Rubric readRubric(const std::filesystem::path& file,
                                const Exercise& exercise = theExercise());

/// The result with its severities, task states, option, score and verdict as the rubric has them:
///  - a failed task passes where the rubric softened its last finding of severity fail; a passed
///    one fails where the rubric made one of its findings fail;
///  - awarded where an option's tasks all pass; needsReview instead where a person must look: the
///    screenshot's task has not passed, unless there was nothing to compare it with, or a task of
///    the option asks for review;
///  - notGraded where a task was not graded for our reasons and no option passes;
///  - needsReview where a task that is not decided asks for it; else notAwarded.
[[nodiscard]] SubmissionResult applyRubric(const Rubric& rubric, SubmissionResult result);

}  // namespace ticker::rubric

#endif
