#ifndef TICKER_METRICS_PICTUREVIEW_H
#define TICKER_METRICS_PICTUREVIEW_H

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ticker::metrics {

inline constexpr std::size_t kChannels = 3;

/// An 8-bit sRGB picture, not owned: rows from the top; red, green, blue.
struct ByteView {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> rgb;  ///< width * height * kChannels
};

/// A view of a picture with these three members, such as raytracer::ByteImage.
template <typename Image>
[[nodiscard]] ByteView viewOf(const Image& image) {
    return {image.width, image.height, image.rgb};
}

/// The same, owning its bytes.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;

    [[nodiscard]] ByteView view() const { return {width, height, rgb}; }
};

/// One number for each pixel (or tile), rows from the top.
struct Map {
    int width = 0;
    int height = 0;
    std::vector<float> values;  ///< width * height
};

/// The result of a metric: one number, and its contributions.
struct Measured {
    double value = 0.0;
    Map map;
};

/// Checks that two pictures can be compared; every metric calls it first.
/// @throws raytracer::InputError with both sizes if they differ, and if a picture is empty or its
///         data does not match its size.
void requireSameSize(const ByteView& reference, const ByteView& test);
void requireSameSize(const Map& reference, const Map& test);

/// Mean of all values; 0 for an empty map.
[[nodiscard]] double meanOf(const Map& map);
/// Largest value; 0 for an empty map.
[[nodiscard]] double largestOf(const Map& map);

}  // namespace ticker::metrics

#endif
