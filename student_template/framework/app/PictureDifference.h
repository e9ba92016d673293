#ifndef RAYTRACER_APP_PICTUREDIFFERENCE_H
#define RAYTRACER_APP_PICTUREDIFFERENCE_H

#include <raytracer/io/ImageReader.h>

#include <string>

namespace raytracer {

/// How far two pictures of one size are apart, and where.
struct PictureDifference {
    double mean = 0.0;  ///< of the channels' absolute differences, bytes
    int largest = 0;    ///< the largest of them, bytes
    int x = 0;          ///< the pixel where that is
    int y = 0;
    double clearShare = 0;  ///< share of the pixels that differ by more than `kClear`
    ByteImage picture;      ///< the differences, four times as strong

    static constexpr int kClear = 8;  ///< bytes; an eye hardly sees less

    /// One line for a person.
    [[nodiscard]] std::string inWords() const;
};

/// @throws InputError where the sizes differ; `nameOfOther` is what it calls the second picture.
[[nodiscard]] PictureDifference differenceOf(const ByteImage& picture, const ByteImage& other,
                                             const std::string& nameOfOther);

}  // namespace raytracer

#endif
