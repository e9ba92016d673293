#ifndef RAYTRACER_APP_PICTUREDIFFERENCE_H
#define RAYTRACER_APP_PICTUREDIFFERENCE_H

#include <raytracer/io/ImageReader.h>

#include <string>

namespace raytracer {

/// Difference of two pictures of the same size.
struct PictureDifference {
    double mean = 0.0;  ///< of the channels' absolute differences, bytes
    int largest = 0;    ///< the largest of them, bytes
    int x = 0;          ///< the pixel with the largest difference
    int y = 0;
    double clearShare = 0;  ///< share of the pixels that differ by more than `kClear`
    ByteImage picture;      ///< the differences, four times as strong

    static constexpr int kClear = 8;  ///< bytes; smaller differences are hardly visible

    /// The difference in one line of words.
    [[nodiscard]] std::string inWords() const;
};

/// @throws InputError if the sizes differ; `nameOfOther` is the name of the second picture in it.
[[nodiscard]] PictureDifference differenceOf(const ByteImage& picture, const ByteImage& other,
                                             const std::string& nameOfOther);

}  // namespace raytracer

#endif
