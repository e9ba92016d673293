#ifndef GRADER_TESTS_IO_PNGBUILDER_H
#define GRADER_TESTS_IO_PNGBUILDER_H

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ticker::testing {

/// PNG's numbers for pixel formats.
enum class PngColour : std::uint8_t { grey = 0, rgb = 2, greyAlpha = 4, rgbAlpha = 6 };

/// The header of a PNG file. It is not checked and may be wrong.
struct PngHeader {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint8_t depth = 8;
    PngColour colour = PngColour::grey;
    bool interlaced = false;
};

/// A PNG file with these bytes as its unpacked rows, each of which begins with a filter byte.
[[nodiscard]] std::string makePng(const PngHeader& header, const std::string& rows);

/// A PNG file around data that is compressed already (or claims to be).
[[nodiscard]] std::string makePngAround(const PngHeader& header, const std::string& packed);

/// One chunk of a PNG file, with its right check sum.
[[nodiscard]] std::string pngChunk(const std::string& type, const std::string& data);

/// `header.height` equal rows, each with filter 0.
[[nodiscard]] std::string equalRows(const PngHeader& header, const std::string& row);

}  // namespace ticker::testing

#endif
