#ifndef TICKER_PIPELINE_SCREENSHOT_H
#define TICKER_PIPELINE_SCREENSHOT_H

#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ticker::pipeline {

/// Size of the handout's pictures, pixels.
inline constexpr int kScreenshotWidth = 640;
inline constexpr int kScreenshotHeight = 480;

/// What a PNG file says of itself.
struct PngHeader {
    int width = 0;
    int height = 0;
    std::uint64_t pixelBytes = 0;  ///< unpacked, with a filter byte for each row
    std::string packed;            ///< the zlib stream that holds them
};

/// The header of a whole PNG file; empty where the bytes are none: another format, cut short, or
/// damaged. Walks over the chunks and their check sums; nothing is unpacked.
[[nodiscard]] std::optional<PngHeader> readPngHeader(std::string_view bytes);

/// Judges the picture as a file: there, a PNG, of the handout's size, with pixels for this size.
/// @param bytes  Empty optional: none was handed in.
[[nodiscard]] TaskReport judgeScreenshotFile(const std::optional<std::string>& bytes);

}  // namespace ticker::pipeline

#endif
