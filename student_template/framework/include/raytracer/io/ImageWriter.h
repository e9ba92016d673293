#ifndef RAYTRACER_IO_IMAGEWRITER_H
#define RAYTRACER_IO_IMAGEWRITER_H

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageReader.h>

#include <filesystem>
#include <string>

namespace raytracer {

/// The 8-bit picture of a linear image, through the tone curve.
[[nodiscard]] ByteImage toBytes(const Image& image);

/// Checks that a picture can be written here, so that a missing folder is reported before a long
/// render and not after it. Writes nothing.
/// @throws InputError if the folder is missing, or the name is that of a folder or a device.
void checkWritable(const std::filesystem::path& file);

/// The bytes of a PNG file.
/// @throws Error if the picture is too large to be encoded.
[[nodiscard]] std::string encodePng(const ByteImage& image);

/// Writes a PNG file, completely or not at all (a temporary file is renamed into place).
/// @throws InputError if the file cannot be written.
void writePng(const ByteImage& image, const std::filesystem::path& file);

/// The same for a linear image, through the tone curve.
void writePng(const Image& image, const std::filesystem::path& file);

/// Writes the linear colours, without the tone curve, as a PFM file: three 32-bit floats for each
/// pixel, little-endian, rows from the bottom as the format requires. Completely or not at all.
/// @throws InputError if the file cannot be written.
void writePfm(const Image& image, const std::filesystem::path& file);

}  // namespace raytracer

#endif
