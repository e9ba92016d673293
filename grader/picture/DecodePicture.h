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

/// Largest picture that is decoded: a screen of 5120 x 2880 pixels fits.
inline constexpr std::uint32_t kLargestSide = 16'384;
inline constexpr std::uint64_t kMostPixels = 16U << 20U;
inline constexpr std::size_t kLargestFile = 64U << 20U;

/// What a picture claims, pixels; may be anything up to 2^32 - 1, also 0.
struct PictureSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// The size in a PNG file's header; empty where the bytes begin as no PNG file does. Nothing else
/// of the file is looked at.
[[nodiscard]] std::optional<PictureSize> claimedSize(std::string_view bytes);

/// Why a student's picture has no pixels.
struct DecodeFailure {
    enum class Kind {
        notPng,     ///< another format, or no picture at all
        tooLarge,   ///< or of no size: nothing was decoded
        animated,   ///< a PNG of several frames: which one is meant?
        truncated,  ///< the file ends too early
        damaged,    ///< a wrong check sum, too few or too many pixels, or no PNG after all
        limit,      ///< the decoder ran out of time or memory
        crashed     ///< the decoder was ended by a signal: somebody attacks it
    };
    Kind kind = Kind::damaged;
    /// What the file is, in our own words: "this is a JPEG picture".
    std::string message;
};

/// What the end of a decoder that gave no answer says about its picture.
/// @throws raytracer::Error (notGradable) where it says something about us.
[[nodiscard]] DecodeFailure failureOf(const sandbox::Outcome& outcome);

using Decoded = std::variant<raytracer::ByteImage, DecodeFailure>;

/// The pixels of a PNG file, decoded in the sandbox. Grey becomes equal channels, alpha is dropped,
/// of 16-bit channels the upper 8 bits are kept, as by `raytracer::decodeImage`; colour profiles
/// and all other ancillary data are not read.
/// @throws raytracer::Error (notGradable) where the sandbox fails for reasons that are ours.
[[nodiscard]] Decoded decodePicture(std::string_view bytes, const sandbox::Sandbox& sandbox,
                                    const sandbox::Limits& limits);

}  // namespace ticker::picture

#endif
