#ifndef RAYTRACER_IO_IMAGEREADER_H
#define RAYTRACER_IO_IMAGEREADER_H

#include <raytracer/geometry/HeightMap.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

/// An 8-bit picture as a file holds it: rows from the top, red, green, blue.
struct ByteImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< width * height * 3
};

/// Reads a PNG file; other formats are refused by name. Grey becomes equal channels with the same
/// values, alpha is dropped, of 16-bit channels the upper 8 bits are kept.
/// @throws InputError where the file is missing, over 64 MiB, no PNG, damaged, or over 16 384
///         pixels on a side or 64 million in all (judged before memory is taken).
[[nodiscard]] ByteImage readImage(const std::filesystem::path& file);

/// The same for a file that is in memory already.
/// @param name  What errors call the file.
/// @throws InputError as `readImage`.
[[nodiscard]] ByteImage decodeImage(std::string_view bytes, const std::string& name);

/// Reads a bump map: height is the linear byte value, the mean of the channels.
/// @throws InputError as `readImage`, and where a side is below `HeightMap::kSmallestSide`.
[[nodiscard]] HeightMap readHeightMap(const std::filesystem::path& file);

}  // namespace raytracer

#endif
