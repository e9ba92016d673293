#ifndef RAYTRACER_IO_IMAGEREADER_H
#define RAYTRACER_IO_IMAGEREADER_H

#include <raytracer/geometry/HeightMap.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

/// An 8-bit picture as stored in a file: rows from the top, red, green, blue.
struct ByteImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< width * height * 3
};

/// Reads a PNG file. For another format, the error says which one it is. Grey becomes three equal
/// channels, alpha is dropped, and 16-bit channels keep their upper 8 bits.
/// @throws InputError if the file is missing, over 64 MiB, not a PNG, damaged, or over 16 384
///         pixels on a side or 64 million in all (checked before memory is allocated).
[[nodiscard]] ByteImage readImage(const std::filesystem::path& file);

/// readImage for a file that is already in memory.
/// @param name  Name of the file in errors.
/// @throws InputError as `readImage`.
[[nodiscard]] ByteImage decodeImage(std::string_view bytes, const std::string& name);

/// Reads a bump map: the height is the linear byte value, the mean of the channels.
/// @throws InputError as `readImage`, and if a side is below `HeightMap::kSmallestSide`.
[[nodiscard]] HeightMap readHeightMap(const std::filesystem::path& file);

}  // namespace raytracer

#endif
