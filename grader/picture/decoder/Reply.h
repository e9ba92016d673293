#ifndef TICKER_PICTURE_DECODER_REPLY_H
#define TICKER_PICTURE_DECODER_REPLY_H

#include <cstdint>

namespace ticker::picture {

/// The decoder's descriptors: the PNG file, and the memory for the reply.
inline constexpr int kFileDescriptor = 3;
inline constexpr int kReplyDescriptor = 4;

/// Result of the decoding.
enum class DecodeState : std::uint32_t {
    unfinished = 0,
    decoded = 0x706E672B,
    animated,
    truncated,
    damaged,
    noMemory
};

/// Header of the reply; the pixels follow: rows from the top, red, green, blue. Both ends run on
/// one machine, so it is sent as it lies in memory.
struct Reply {
    DecodeState state = DecodeState::unfinished;
    std::uint32_t reserved[3] = {};
};

}  // namespace ticker::picture

#endif
