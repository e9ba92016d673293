#ifndef TICKER_PICTURE_DECODEPICTURE_H
#define TICKER_PICTURE_DECODEPICTURE_H

#include <grader/sandbox/Sandbox.h>

#include <raytracer/io/ImageReader.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace ticker::picture {

/// Largest side of a decoded picture; a screen of 5120 x 2880 pixels fits.
inline constexpr std::uint32_t kLargestSide = 16'384;
inline constexpr std::uint64_t kMostPixels = 16U << 20U;
inline constexpr std::size_t kLargestFile = 64U << 20U;

/// The size in a picture's header, pixels; untrusted: any value up to 2^32 - 1, including 0.
struct PictureSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// The size in a PNG file's header; empty if the bytes do not begin like a PNG file. Nothing else
/// of the file is read.
[[nodiscard]] std::optional<PictureSize> claimedSize(std::string_view bytes);

/// Why a student's picture could not be decoded.
struct DecodeFailure {
    enum class Kind {
        notPng,     ///< another format, or no picture at all
        tooLarge,   ///< or of size 0: it was not decoded
        animated,   ///< a PNG with several frames: ambiguous
        truncated,  ///< the file ends too early
        damaged,    ///< a wrong check sum, too few or too many pixels, or not a PNG after all
        limit,      ///< the decoder ran out of time or memory
        crashed     ///< a signal ended the decoder: possibly an attack
    };
    Kind kind = Kind::damaged;
    /// Says what is wrong, without quoting the file: "this is a JPEG picture".
    std::string message;
};

/// Translates the end of a decoder that gave no reply.
/// @throws raytracer::Error (notGradable) if the fault is the grader's.
[[nodiscard]] DecodeFailure failureOf(const sandbox::Outcome& outcome);

using Decoded = std::variant<raytracer::ByteImage, DecodeFailure>;

/// The pixels of a PNG file, decoded in the sandbox. Like `raytracer::decodeImage`, grey becomes
/// equal channels, alpha is dropped, and 16-bit channels keep their upper 8 bits. Colour profiles
/// and all other ancillary data are ignored.
/// @throws raytracer::Error (notGradable) if the sandbox itself fails.
[[nodiscard]] Decoded decodePicture(std::string_view bytes, const sandbox::Sandbox& sandbox,
                                    const sandbox::Limits& limits);

}  // namespace ticker::picture

#endif
