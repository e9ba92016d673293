#ifndef TICKER_METRICS_COLOURS_H
#define TICKER_METRICS_COLOURS_H

#include <grader/metrics/PictureView.h>

#include <cstdint>
#include <vector>

namespace ticker::metrics {

/// A map as a picture: red, green, blue. 0 is black; `full` and above are the brightest colour of
/// the "magma" scale (Smith, van der Walt: perceptually uniform, legible in grey and to the
/// colour-blind).
[[nodiscard]] std::vector<std::uint8_t> magma(const Map& map, double full = 1.0);

/// A signed map as a picture: white at 0, blue below, red above, saturated at -`full` and `full`.
[[nodiscard]] std::vector<std::uint8_t> blueWhiteRed(const Map& map, double full);

}  // namespace ticker::metrics

#endif
