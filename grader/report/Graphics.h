#ifndef TICKER_REPORT_GRAPHICS_H
#define TICKER_REPORT_GRAPHICS_H

#include <grader/result/Finding.h>

#include <string>
#include <string_view>

namespace ticker::report {

/// "data:image/png;base64,..." of a PNG file's bytes.
[[nodiscard]] std::string pngAddress(std::string_view png);

/// An SVG element: the points, and the outline of the shape that was expected.
[[nodiscard]] std::string scatterSvg(const ScatterPlot& plot);

/// The PNG file of a raster, in its colours.
[[nodiscard]] std::string rasterPng(const Raster& raster);

}  // namespace ticker::report

#endif
