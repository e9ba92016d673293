#ifndef RAYTRACER_IO_IMAGEWRITER_H
#define RAYTRACER_IO_IMAGEWRITER_H

#include <raytracer/image/Image.h>
#include <raytracer/io/ImageReader.h>

#include <filesystem>

namespace raytracer {

/// The 8-bit picture of a linear image, through the tone curve.
[[nodiscard]] ByteImage toBytes(const Image& image);

/// Writes a PNG file: whole or not at all (a temporary file is renamed into place).
/// @throws InputError where the file cannot be written.
void writePng(const ByteImage& image, const std::filesystem::path& file);

/// The same for a linear image, through the tone curve.
void writePng(const Image& image, const std::filesystem::path& file);

}  // namespace raytracer

#endif
