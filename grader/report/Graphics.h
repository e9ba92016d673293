#ifndef TICKER_REPORT_GRAPHICS_H
#define TICKER_REPORT_GRAPHICS_H

#include <grader/result/Finding.h>

#include <string>
#include <string_view>

namespace ticker::report {

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

/// "data:image/png;base64,..." of a PNG file's bytes.
[[nodiscard]] std::string pngAddress(std::string_view png);

/// An SVG element with a description: the points, axes with a scale, and the outline of the
/// expected shape.
[[nodiscard]] std::string scatterSvg(const ScatterPlot& plot);

}  // namespace ticker::report

#endif
