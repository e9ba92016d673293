#ifndef TICKER_PICTURE_ENCODEPICTURE_H
#define TICKER_PICTURE_ENCODEPICTURE_H

#include <raytracer/io/ImageReader.h>

#include <string>

namespace ticker::picture {

/// A PNG file for pages: made five times as fast as by the framework's writer, which students have,
/// and smaller where pictures are noisy. The same picture gives the same bytes.
/// @throws raytracer::Error where the picture is empty or memory runs out.
[[nodiscard]] std::string encodePicture(const raytracer::ByteImage& image);

}  // namespace ticker::picture

#endif
