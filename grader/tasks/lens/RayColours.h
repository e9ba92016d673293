#ifndef TICKER_TASKS_DISTRIBUTED_RAYCOLOURS_H
#define TICKER_TASKS_DISTRIBUTED_RAYCOLOURS_H

#include <grader/tasks/lens/LensLog.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ticker::tasks {

/// Equal but for the rounding of means of fifty colours in single precision.
[[nodiscard]] bool isNear(const ColourRGB& a, const ColourRGB& b);

/// What `trace` gave for the rays of a pixel.
[[nodiscard]] std::vector<ColourRGB> valuesOf(const LensPixel& pixel);

[[nodiscard]] ColourRGB meanOf(const ColourRGB* first, std::size_t count);

/// The factor between the mean of what `change` makes of the rays' colours and the pixel's colour,
/// where it is the same everywhere; else 0.
[[nodiscard]] double commonFactor(const LensLog& log,
                                  const std::function<ColourRGB(const ColourRGB&)>& change);

/// Which curve every ray's colour went through before the mean was taken, as words that go on
/// after "the mean of its rays' colours; "; empty where none that is known did.
[[nodiscard]] std::string curveOfRays(const LensLog& log);

}  // namespace ticker::tasks

#endif
