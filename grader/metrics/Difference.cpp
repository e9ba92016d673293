#include <grader/metrics/Difference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ticker::metrics {
namespace {

/// A map of `ofPixel`, applied to the three bytes of each pixel.
template <typename Function>
Map eachPixel(const ByteView& reference, const ByteView& test, Function ofPixel) {
    requireSameSize(reference, test);
    Map map{reference.width, reference.height, {}};
    const std::size_t pixels = reference.rgb.size() / kChannels;
    map.values.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        map.values.push_back(
            static_cast<float>(ofPixel(&reference.rgb[i * kChannels], &test.rgb[i * kChannels])));
    return map;
}

/// A map of `ofChannel`, applied to two bytes and averaged over the channels.
template <typename Function>
Map channelMean(const ByteView& reference, const ByteView& test, Function ofChannel) {
    return eachPixel(reference, test, [&](const std::uint8_t* r, const std::uint8_t* t) {
        double sum = 0.0;
        for (std::size_t c = 0; c < kChannels; ++c)
            sum += ofChannel(static_cast<double>(r[c]), static_cast<double>(t[c]));
        return sum / static_cast<double>(kChannels);
    });
}

int largestOfPixel(const std::uint8_t* r, const std::uint8_t* t) {
    int largest = 0;
    for (std::size_t c = 0; c < kChannels; ++c)
        largest = std::max(largest, std::abs(int{t[c]} - int{r[c]}));
    return largest;
}

}  // namespace

Measured rmse(const ByteView& reference, const ByteView& test) {
    Measured result;
    result.map = channelMean(reference, test, [](double r, double t) { return (t - r) * (t - r); });
    result.value = std::sqrt(meanOf(result.map));
    for (float& value : result.map.values)
        value = std::sqrt(value);
    return result;
}

Measured psnr(const ByteView& reference, const ByteView& test) {
    Measured result = rmse(reference, test);
    result.value = result.value > 0.0 ? 20.0 * std::log10(255.0 / result.value)
                                      : std::numeric_limits<double>::infinity();
    return result;
}

Measured relativeMse(const ByteView& reference, const ByteView& test) {
    // The usual guard against division by zero at black, as in pbrt's imgtool.
    constexpr double kGuard = 0.01;
    Measured result;
    result.map = channelMean(reference, test, [](double r, double t) {
        const double from = r / 255.0;
        const double difference = (t - r) / 255.0;
        return difference * difference / (from * from + kGuard);
    });
    result.value = meanOf(result.map);
    return result;
}

Measured largestDifference(const ByteView& reference, const ByteView& test) {
    Measured result;
    result.map = eachPixel(reference, test, largestOfPixel);
    result.value = largestOf(result.map);
    return result;
}

Measured differingPixels(const ByteView& reference, const ByteView& test, int tolerance) {
    Measured result;
    result.map =
        eachPixel(reference, test, [tolerance](const std::uint8_t* r, const std::uint8_t* t) {
            return largestOfPixel(r, t) > tolerance ? 1.0 : 0.0;
        });
    result.value =
        static_cast<double>(std::count(result.map.values.begin(), result.map.values.end(), 1.0F));
    return result;
}

}  // namespace ticker::metrics
