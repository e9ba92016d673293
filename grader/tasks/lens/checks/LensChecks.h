#ifndef TICKER_TASKS_LENS_CHECKS_LENSCHECKS_H
#define TICKER_TASKS_LENS_CHECKS_LENSCHECKS_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/answers/LensLog.h>

#include <optional>

namespace ticker::tasks {

/// Each check looks at one property of the render at the handout's settings, and returns a finding
/// if it is wrong.
[[nodiscard]] std::optional<Finding> checkLensCounts(const LensLog& log);
[[nodiscard]] std::optional<Finding> checkAverage(const LensLog& log);
[[nodiscard]] std::optional<Finding> checkFocus(const LensLog& log);
[[nodiscard]] std::optional<Finding> checkBounces(const LensLog& log);
/// Whether every ray crosses the focal plane inside its own pixel's square. The squares of a tiny
/// frame are so large that many mistakes stay inside them.
[[nodiscard]] bool staysInPixels(const LensLog& log);
/// A warning if the lens points repeat from pixel to pixel.
[[nodiscard]] std::optional<Finding> checkPattern(const LensLog& log);

/// Which of the two accepted apertures the lens points fill.
struct ApertureVerdict {
    std::optional<Finding> finding;
    double factor = 1.0;  ///< half-width / dofAmount: 1 or 0.5
};
[[nodiscard]] ApertureVerdict checkAperture(const LensLog& log);

}  // namespace ticker::tasks

#endif
