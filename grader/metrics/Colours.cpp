#include <grader/metrics/Colours.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace ticker::metrics {
namespace {

using Colour = std::array<std::uint8_t, 3>;

std::array<Colour, 256> makeMagma() {
    cv::Mat index(1, 256, CV_8U);
    for (int i = 0; i < 256; ++i)
        index.at<std::uint8_t>(0, i) = static_cast<std::uint8_t>(i);
    cv::Mat colours;
    cv::applyColorMap(index, colours, cv::COLORMAP_MAGMA);
    std::array<Colour, 256> table{};
    for (int i = 0; i < 256; ++i) {
        const auto& bgr = colours.at<cv::Vec3b>(0, i);
        table[static_cast<std::size_t>(i)] = {bgr[2], bgr[1], bgr[0]};
    }
    return table;
}

/// 0 to 1; NaN gives 1, so that it is visible.
double share(float value, double full) {
    const double ratio = static_cast<double>(value) / full;
    return ratio <= 1.0 ? std::max(ratio, 0.0) : 1.0;
}

}  // namespace

std::vector<std::uint8_t> magma(const Map& map, double full) {
    static const std::array<Colour, 256> kTable = makeMagma();
    std::vector<std::uint8_t> rgb;
    rgb.reserve(map.values.size() * 3);
    for (const float value : map.values) {
        const Colour& colour =
            kTable[static_cast<std::size_t>(std::lround(share(value, full) * 255.0))];
        rgb.insert(rgb.end(), colour.begin(), colour.end());
    }
    return rgb;
}

std::vector<std::uint8_t> blueWhiteRed(const Map& map, double full) {
    constexpr Colour kBelow{33, 102, 172};
    constexpr Colour kAbove{178, 24, 43};
    std::vector<std::uint8_t> rgb;
    rgb.reserve(map.values.size() * 3);
    for (const float value : map.values) {
        const Colour& end = value < 0.0F ? kBelow : kAbove;
        const double strength = share(std::abs(value), full);
        for (const std::uint8_t channel : end)
            rgb.push_back(
                static_cast<std::uint8_t>(std::lround(255.0 + strength * (channel - 255.0))));
    }
    return rgb;
}

}  // namespace ticker::metrics
