#include <grader/tasks/screenshot/Agreement.h>

#include <grader/metrics/Difference.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ticker::tasks::screenshot {
namespace {

// Compilers and processors round differently; a texel's border may fall on the other side of a
// pixel. The right solutions of the samples and of grader/corpus/unseen show no such difference.
constexpr int kSteps = 3;
constexpr double kMostDiffering = 0.02;
// JPEG of quality 90 and above has less. The smallest value of a wrong sign is 25 (an inverted
// longitude).
constexpr double kLossyRms = 6.0;

double brightness(const std::uint8_t* rgb) {
    return 0.25 * rgb[0] + 0.5 * rgb[1] + 0.25 * rgb[2];
}

// The square of the second difference along a row, divided by 6. It removes linear gradients;
// independent noise has six times its variance in the second difference.
double squaredBend(const ByteView& picture, int x, int y) {
    const auto at = [&](int column) {
        return brightness(
            &picture
                 .rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(column))]);
    };
    const double bend = 2.0 * at(x) - at(x - 1) - at(x + 1);
    return bend * bend / 6.0;
}

}  // namespace

Agreement agreementOf(const ByteView& windows, const ByteView& own, bool isRandom) {
    Agreement result;
    result.rms = metrics::rmse(own, windows).value;
    if (isRandom) {
        result.energy = metrics::noiseEnergy(own, windows);
        result.agrees = result.energy.probability() >= kSmallestChance;
        return result;
    }
    const auto pixels = static_cast<double>(own.width) * own.height;
    result.differing = metrics::differingPixels(own, windows, kSteps).value / pixels;
    result.isLossy = result.differing > kMostDiffering;
    result.agrees = !result.isLossy || result.rms <= kLossyRms;
    return result;
}

std::optional<double> noiseRatio(const ByteView& windows, const ByteView& own) {
    constexpr int kTile = 8;
    constexpr double kNoisy = 9.0;  // three steps of a byte, squared: far above rounding
    std::vector<double> ratios;
    for (int top = 0; top + kTile <= own.height; top += kTile)
        for (int left = 0; left + kTile <= own.width; left += kTile) {
            double first = 0.0;
            double second = 0.0;
            for (int y = top; y < top + kTile; ++y)
                for (int x = left + 1; x < left + kTile - 1; ++x) {
                    first += squaredBend(windows, x, y);
                    second += squaredBend(own, x, y);
                }
            if (second >= kNoisy * kTile * (kTile - 2)) ratios.push_back(first / second);
        }
    if (ratios.empty()) return std::nullopt;
    // An edge in a tile is not noise; the median tile has no edge.
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

}  // namespace ticker::tasks::screenshot
