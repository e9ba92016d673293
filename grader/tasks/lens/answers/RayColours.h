#ifndef TICKER_TASKS_LENS_ANSWERS_RAYCOLOURS_H
#define TICKER_TASKS_LENS_ANSWERS_RAYCOLOURS_H

#include <grader/tasks/lens/answers/LensLog.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ticker::tasks {

/// Equal up to the rounding of means of fifty colours in single precision.
[[nodiscard]] bool isNear(const ColourRGB& a, const ColourRGB& b);

/// Results of `trace` for the rays of a pixel.
[[nodiscard]] std::vector<ColourRGB> valuesOf(const LensPixel& pixel);

[[nodiscard]] ColourRGB meanOf(const ColourRGB* first, std::size_t count);

/// The ratio of the pixel's colour to the mean of `change` of the rays' colours if it is the same
/// everywhere; 0 otherwise.
[[nodiscard]] double commonFactor(const LensLog& log,
                                  const std::function<ColourRGB(const ColourRGB&)>& change);

/// The curve that was applied to every ray's colour before the mean, as words that continue "the
/// mean of its rays' colours; "; empty if no known curve fits.
[[nodiscard]] std::string curveOfRays(const LensLog& log);

}  // namespace ticker::tasks

#endif
