#include <grader/lab/agreement/MomentAgreement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace ticker::calibrate {
namespace {

using oracle::Covariance;
using oracle::Moments;

constexpr int kTile = 6;
// Difference between single and double precision in a pixel; neighbours' errors may have one sign,
// so that they add up.
constexpr double kRounding = 5e-6;

using Triple = std::array<double, 3>;

Triple triple(const raytracer::ColourRGB& c) {
    return {c.r, c.g, c.b};
}

Triple variances(const Covariance& v) {
    return {v.rr, v.gg, v.bb};
}

/// Sums over one tile and channel.
struct TileSum {
    double difference = 0.0;
    double variance = 0.0;
    int pixels = 0;

    [[nodiscard]] double z() const {
        const double rounding = pixels * kRounding;
        return difference / std::sqrt(variance + rounding * rounding);
    }
};

/// z of every tile and channel, from differences and their variances.
std::vector<double> tileZ(int width, int height, const std::vector<Triple>& difference,
                          const std::vector<Triple>& variance) {
    const int across = (width + kTile - 1) / kTile;
    const int down = (height + kTile - 1) / kTile;
    std::vector<TileSum> tiles(static_cast<std::size_t>(across * down) * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const auto i = static_cast<std::size_t>(y * width + x);
                const auto tile = static_cast<std::size_t>((y / kTile) * across + x / kTile);
                TileSum& sum = tiles[tile * 3 + c];
                sum.difference += difference[i][c];
                sum.variance += variance[i][c];
                ++sum.pixels;
            }
    std::vector<double> result;
    for (const TileSum& tile : tiles)
        result.push_back(tile.z());
    return result;
}

double largestOf(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

/// Sums over renders: of each pixel, and of each whole picture's squared deviation from the mean.
struct Sums {
    int renders = 0;
    std::vector<Triple> pixels;
    double squares = 0.0;
    double squares2 = 0.0;

    void add(const raytracer::Image& image, const Moments& moments) {
        double deviation = 0.0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Triple value = triple(image.pixels()[i]);
            const Triple mean = triple(moments.mean[i]);
            for (std::size_t c = 0; c < 3; ++c) {
                pixels[i][c] += value[c];
                deviation += (value[c] - mean[c]) * (value[c] - mean[c]);
            }
        }
        squares += deviation;
        squares2 += deviation * deviation;
        ++renders;
    }
};

void compareMeans(const Sums& sums, const Moments& moments, Agreement& agreement) {
    std::vector<Triple> difference(sums.pixels.size());
    std::vector<Triple> variance(sums.pixels.size());
    for (std::size_t i = 0; i < sums.pixels.size(); ++i) {
        const Triple mean = triple(moments.mean[i]);
        const Triple error = triple(moments.meanError[i]);
        const Triple own = variances(moments.covariance[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            difference[i][c] = sums.pixels[i][c] / sums.renders - mean[c];
            variance[i][c] = own[c] / sums.renders + error[c];
        }
    }
    const std::vector<double> z = tileZ(moments.width, moments.height, difference, variance);
    agreement.largestZ = largestOf(z);
    agreement.tiles = static_cast<int>(z.size());
    for (const double value : z)
        agreement.meanZ2 += value * value / static_cast<double>(z.size());
}

void compareVariances(const Sums& sums, const Moments& moments, Agreement& agreement) {
    double expected = 0.0;
    for (const Covariance& v : moments.covariance)
        expected += v.rr + v.gg + v.bb;
    const double mean = sums.squares / sums.renders;
    const double spread =
        std::sqrt(std::max(0.0, sums.squares2 / sums.renders - mean * mean) / (sums.renders - 1));
    // A picture without noise: only rounding is left.
    const double rounding = 3.0 * static_cast<double>(sums.pixels.size()) * kRounding * kRounding;
    agreement.varianceZ = std::abs(mean - expected) / std::hypot(spread, rounding);
    agreement.varianceRatio = (mean + rounding) / (expected + rounding);
}

}  // namespace

Agreement compare(const Moments& moments, int renders,
                  const std::function<raytracer::Image(int)>& render) {
    Sums sums;
    sums.pixels.resize(moments.mean.size());
    for (int number = 1; number <= renders; ++number)
        sums.add(render(number), moments);
    Agreement agreement;
    compareMeans(sums, moments, agreement);
    compareVariances(sums, moments, agreement);
    return agreement;
}

double largestTileZ(const Moments& a, const Moments& b) {
    std::vector<Triple> difference;
    std::vector<Triple> variance;
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
        difference.push_back(triple(a.mean[i] - b.mean[i]));
        variance.push_back(triple(a.meanError[i] + b.meanError[i]));
    }
    return largestOf(tileZ(a.width, a.height, difference, variance));
}

}  // namespace ticker::calibrate
