#ifndef TICKER_TOOLS_TERMINALPICTURE_H
#define TICKER_TOOLS_TERMINALPICTURE_H

#include <raytracer/io/ImageReader.h>

#include <string_view>

namespace ticker {

/// The half blocks that a terminal shows after printing `written`, as a picture: two pixels for
/// each cell, one above the other. Understands what tick1star's preview writes: 24-bit colours,
/// xterm's colour cube, carriage return, line feed, cursor up, and erase to the end of the line.
/// Cells with any other character are black.
[[nodiscard]] raytracer::ByteImage terminalPicture(std::string_view written);

/// Draws each pixel as a square of `side` pixels.
[[nodiscard]] raytracer::ByteImage enlarged(const raytracer::ByteImage& picture, int side);

}  // namespace ticker

#endif
