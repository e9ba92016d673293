#ifndef TICKER_PICTURE_DECODER_DECODEPNG_H
#define TICKER_PICTURE_DECODER_DECODEPNG_H

#include <grader/picture/decoder/Reply.h>

#include <cstdint>
#include <span>

namespace ticker::picture {

/// Decodes a whole PNG file. `pixels` has width * height * 3 bytes, as the file's header says: a
/// file of another size is `damaged`. Where it is not `decoded`, `pixels` may hold anything.
[[nodiscard]] DecodeState decodePng(std::span<const std::uint8_t> file,
                                    std::span<std::uint8_t> pixels);

}  // namespace ticker::picture

#endif
