#ifndef TICKER_TASKS_LENS_CHECKS_LENSLINES_H
#define TICKER_TASKS_LENS_CHECKS_LENSLINES_H

#include <grader/result/SubmissionResult.h>
#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/answers/LensShape.h>

#include <optional>

namespace ticker::tasks {

/// A finding if rays start on lines or in a part of the lens, instead of all over a square.
[[nodiscard]] std::optional<Finding> checkLines(const LensLog& log, const Lens& lens,
                                                const ShapeVerdict& shape);

}  // namespace ticker::tasks

#endif
