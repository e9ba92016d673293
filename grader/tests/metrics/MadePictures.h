#ifndef TICKER_TESTS_METRICS_MADEPICTURES_H
#define TICKER_TESTS_METRICS_MADEPICTURES_H

#include <grader/metrics/PictureView.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace ticker::metrics {

using Rgb = std::array<int, 3>;

inline Picture makePicture(int width, int height, const std::function<Rgb(int, int)>& colourAt) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int channel : colourAt(x, y))
                picture.rgb.push_back(static_cast<std::uint8_t>(channel));
    return picture;
}

inline Picture flat(int width, int height, const Rgb& colour) {
    return makePicture(width, height, [&](int, int) { return colour; });
}

/// The generator of Numerical Recipes, top byte of each state.
class Bytes {
public:
    explicit Bytes(std::uint32_t seed) : state_(seed) {}
    int next() {
        state_ = 1664525U * state_ + 1013904223U;
        return static_cast<int>(state_ >> 24U);
    }

private:
    std::uint32_t state_;
};

/// A picture plus noise of up to +-16 in every channel.
inline Picture withNoise(const Picture& clean, std::uint32_t seed) {
    Bytes bytes{seed};
    Picture noisy = clean;
    for (std::uint8_t& value : noisy.rgb)
        value = static_cast<std::uint8_t>(
            std::min(std::max(static_cast<int>(value) + bytes.next() % 33 - 16, 0), 255));
    return noisy;
}

}  // namespace ticker::metrics

#endif
