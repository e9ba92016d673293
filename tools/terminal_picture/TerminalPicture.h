#ifndef TICKER_TOOLS_TERMINALPICTURE_H
#define TICKER_TOOLS_TERMINALPICTURE_H

#include <raytracer/io/ImageReader.h>

#include <string_view>

namespace ticker {

/// The half blocks that a terminal shows after `written` came, as a picture: two pixels for each
/// cell, one above the other. Knows what tick1star's preview writes: colours of 24 bits and of
/// xterm's cube, carriage return, line feed, cursor up, and erase to the end of the line; cells
/// with anything but a half block are black.
[[nodiscard]] raytracer::ByteImage terminalPicture(std::string_view written);

/// Each pixel as a square of `side` pixels.
[[nodiscard]] raytracer::ByteImage enlarged(const raytracer::ByteImage& picture, int side);

}  // namespace ticker

#endif
