#include "PictureDifference.h"

#include <raytracer/base/Error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace raytracer {
namespace {

constexpr int kStrength = 4;

std::string sizeOf(const ByteImage& picture) {
    return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

}  // namespace

std::string PictureDifference::inWords() const {
    if (largest == 0) return "the pictures are equal";
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "mean difference %.2f of 255, largest %d at (%d, %d), %.1f %% of the pixels "
                  "differ by more than %d",
                  mean, largest, x, y, 100.0 * clearShare, kClear);
    return text.data();
}

PictureDifference differenceOf(const ByteImage& picture, const ByteImage& other,
                               const std::string& nameOfOther) {
    if (picture.width != other.width || picture.height != other.height)
        throw InputError(nameOfOther, 0,
                         "is " + sizeOf(other) + " pixels, expected " + sizeOf(picture) +
                             " as the picture to compare");
    PictureDifference difference;
    difference.picture = {picture.width, picture.height, {}};
    difference.picture.rgb.reserve(picture.rgb.size());
    double sum = 0.0;
    double clear = 0.0;
    const std::size_t pixels = picture.rgb.size() / 3;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        int most = 0;
        for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
            const int apart = std::abs(int{picture.rgb[i]} - int{other.rgb[i]});
            sum += apart;
            most = std::max(most, apart);
            difference.picture.rgb.push_back(
                static_cast<std::uint8_t>(std::min(255, kStrength * apart)));
        }
        if (most > PictureDifference::kClear) clear += 1.0;
        if (most <= difference.largest) continue;
        difference.largest = most;
        difference.x = static_cast<int>(pixel % static_cast<std::size_t>(picture.width));
        difference.y = static_cast<int>(pixel / static_cast<std::size_t>(picture.width));
    }
    difference.mean = sum / static_cast<double>(picture.rgb.size());
    difference.clearShare = clear / static_cast<double>(pixels);
    return difference;
}

}  // namespace raytracer
