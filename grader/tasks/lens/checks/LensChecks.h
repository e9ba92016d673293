#ifndef TICKER_TASKS_LENS_CHECKS_LENSCHECKS_H
#define TICKER_TASKS_LENS_CHECKS_LENSCHECKS_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/answers/LensLog.h>

#include <cstddef>
#include <optional>
#include <string>

namespace ticker::tasks {

/// Each check looks at one property of a render, and returns a finding if it is wrong.
[[nodiscard]] std::optional<Finding> checkLensCounts(const LensLog& log);
/// A finding if every pixel without a visible ray has the colour of a neighbour with rays. Such
/// pixels are copies, since the means of two pixels' own random rays differ.
[[nodiscard]] std::optional<Finding> checkCopies(const LensLog& log);
[[nodiscard]] std::optional<Finding> checkAverage(const LensLog& log);
[[nodiscard]] std::optional<Finding> checkFocus(const LensLog& log);
[[nodiscard]] std::optional<Finding> checkBounces(const LensLog& log);
/// Whether every ray crosses the focal plane inside its own pixel's square. The squares of a tiny
/// frame are so large that many mistakes stay inside them.
[[nodiscard]] bool staysInPixels(const LensLog& log);
/// A warning if the lens points repeat from pixel to pixel.
[[nodiscard]] std::optional<Finding> checkPattern(const LensLog& log);

/// Column and row of a pixel of the log in its picture, in words.
[[nodiscard]] std::string placeOf(const LensLog& log, std::ptrdiff_t pixel);

/// Which of the two accepted apertures the lens points fill.
struct ApertureVerdict {
    std::optional<Finding> finding;
    double factor = 1.0;  ///< half-width / dofAmount: 1 or 0.5
};
[[nodiscard]] ApertureVerdict checkAperture(const LensLog& log);

}  // namespace ticker::tasks

#endif
