#ifndef TICKER_ORACLE_FLOATTIFF_H
#define TICKER_ORACLE_FLOATTIFF_H

#include <raytracer/image/ColourRGB.h>

#include <filesystem>
#include <vector>

namespace ticker::oracle {

/// A picture of 32-bit floats: rows from the top, red, green, blue.
struct FloatPicture {
    int width = 0;
    int height = 0;
    std::vector<raytracer::ColourRGB> pixels;
};

/// Writes a compressed TIFF file, atomically.
/// @throws raytracer::InputError if it cannot be written.
void writeTiff(const FloatPicture& picture, const std::filesystem::path& file);

/// @throws raytracer::InputError if the file is missing or holds anything but three 32-bit floats
///         for each pixel.
[[nodiscard]] FloatPicture readTiff(const std::filesystem::path& file);

}  // namespace ticker::oracle

#endif
