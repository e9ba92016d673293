#ifndef TICKER_TASKS_LENS_ANSWERS_LENSMEANS_H
#define TICKER_TASKS_LENS_ANSWERS_LENSMEANS_H

#include <grader/probe/Question.h>
#include <grader/result/SubmissionResult.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// A pixel's colour, and the right mean of its rays' colours.
struct PixelMean {
    probe::ColourRGB mean;
    probe::ColourRGB colour;
    double rays = 0.0;
};

/// Names what was done to right means: earlier pixels were added, each mean was scaled, or each
/// went through a curve. Empty if none of these explains every pixel. For pictures that are known
/// to be wrong: this is a name, not a verdict.
[[nodiscard]] std::optional<Finding> changeOfMeans(const std::vector<PixelMean>& pixels);

}  // namespace ticker::tasks

#endif
