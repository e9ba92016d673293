#ifndef TICKER_TASKS_LENS_ANSWERS_LENSPLOTS_H
#define TICKER_TASKS_LENS_ANSWERS_LENSPLOTS_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/answers/LensLog.h>

namespace ticker::tasks {

/// Where rays leave the lens, with the two accepted squares.
[[nodiscard]] ScatterPlot plotLens(const LensLog& log);

/// Where the rays of each pixel cross the focal plane, relative to the pixel's focal point, with
/// half a pixel of the handout's picture.
[[nodiscard]] ScatterPlot plotFocus(const LensLog& log);

}  // namespace ticker::tasks

#endif
