#ifndef TICKER_TASKS_DISTRIBUTED_LENSMEANS_H
#define TICKER_TASKS_DISTRIBUTED_LENSMEANS_H

#include <grader/probe/Question.h>
#include <grader/result/SubmissionResult.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// A pixel, and the mean that its colour should have been.
struct PixelMean {
    probe::ColourRGB mean;
    probe::ColourRGB colour;
    double rays = 0.0;
};

/// Says what was done to means that are right otherwise: what earlier pixels gave was added, each
/// was scaled, or each went through a curve. Empty where none of these explains every pixel.
///
/// For pictures that are known to be wrong: it gives a name, not a verdict.
[[nodiscard]] std::optional<Finding> changeOfMeans(const std::vector<PixelMean>& pixels);

}  // namespace ticker::tasks

#endif
