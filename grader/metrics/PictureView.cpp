#include <grader/metrics/PictureView.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace ticker::metrics {
namespace {

template <typename View>
void requireSame(const View& reference, const View& test, std::size_t referenceLength,
                 std::size_t testLength, std::size_t channels) {
    const auto require = [channels](const View& view, std::size_t length) {
        if (view.width < 1 || view.height < 1)
            throw raytracer::InputError(
                "", 0, fmt::format("a picture of {} x {} pixels", view.width, view.height));
        const auto expected =
            static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height) * channels;
        if (length != expected)
            throw raytracer::InputError(
                "", 0,
                fmt::format("a picture of {} x {} pixels has {} values, expected {}", view.width,
                            view.height, length, expected));
    };
    require(reference, referenceLength);
    require(test, testLength);
    if (reference.width != test.width || reference.height != test.height)
        throw raytracer::InputError(
            "", 0,
            fmt::format("the pictures differ in size: {} x {} and {} x {} pixels", reference.width,
                        reference.height, test.width, test.height));
}

}  // namespace

void requireSameSize(const ByteView& reference, const ByteView& test) {
    requireSame(reference, test, reference.rgb.size(), test.rgb.size(), 3);
}

void requireSameSize(const Map& reference, const Map& test) {
    requireSame(reference, test, reference.values.size(), test.values.size(), 1);
}

double meanOf(const Map& map) {
    if (map.values.empty()) return 0.0;
    return std::accumulate(map.values.begin(), map.values.end(), 0.0) /
           static_cast<double>(map.values.size());
}

double largestOf(const Map& map) {
    if (map.values.empty()) return 0.0;
    return *std::max_element(map.values.begin(), map.values.end());
}

}  // namespace ticker::metrics
