#ifndef TICKER_RUBRIC_RUBRIC_H
#define TICKER_RUBRIC_RUBRIC_H

#include <grader/exercise/Exercise.h>
#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ticker::rubric {

/// The conditions for the tick, as data; see rubric.schema.json.
struct Rubric {
    double maxScore = 1.0;
    std::vector<Option> options;
    std::string screenshotTask;                  ///< empty: screenshots are not required
    std::map<std::string, Severity> severities;  ///< finding id -> severity of this course
};

/// Reads a rubric file.
/// @throws raytracer::InputError with the file, the line, the member and what was expected, also
///         for an unknown finding.
[[nodiscard]] Rubric readRubric(const std::filesystem::path& file,
                                const Exercise& exercise = defaultExercise());

/// The result with severities, task states, option, score and verdict according to the rubric:
///  - a failed task passes if the rubric softens its last finding of severity fail; a passed task
///    fails if the rubric makes one of its findings fail;
///  - awarded if all tasks of an option pass; needsReview instead if a ticker must look: the
///    screenshot's task has not passed although there was something to compare it with, or a task
///    of the option asks for review;
///  - where other options could add to the points of those that pass without review: notGraded if
///    the grader failed on a task, needsReview if tasks in doubt are all that they lack;
///  - notGraded if the grader failed on a task and no option passes;
///  - needsReview if an undecided task asks for it; otherwise notAwarded.
[[nodiscard]] SubmissionResult applyRubric(const Rubric& rubric, SubmissionResult result);

}  // namespace ticker::rubric

#endif
