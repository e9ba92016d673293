#ifndef TICKER_PICTURE_DECODER_DECODEPNG_H
#define TICKER_PICTURE_DECODER_DECODEPNG_H

#include <grader/picture/decoder/Reply.h>

#include <cstdint>
#include <span>

namespace ticker::picture {

/// Decodes a whole PNG file. `pixels` has width * height * 3 bytes, by the file's header; if the
/// file holds another number of pixels, it is `damaged`. Unless the result is `decoded`, the
/// contents of `pixels` are undefined.
[[nodiscard]] DecodeState decodePng(std::span<const std::uint8_t> file,
                                    std::span<std::uint8_t> pixels);

}  // namespace ticker::picture

#endif
