#include <grader/tests/oracle/Agreement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ticker::oracle::test {
namespace {

constexpr int kTile = 6;
// Single precision against double: below 5e-6 in a pixel, and neighbours may all go one way.
constexpr double kRounding = 5e-6;

using Triple = std::array<double, 3>;

Triple triple(const raytracer::ColourRGB& c) {
    return {c.r, c.g, c.b};
}

/// z of every tile and channel, from differences and their variances.
std::vector<double> tileZ(int width, int height, const std::vector<Triple>& difference,
                          const std::vector<Triple>& variance) {
    std::vector<double> result;
    for (int top = 0; top < height; top += kTile)
        for (int left = 0; left < width; left += kTile)
            for (std::size_t c = 0; c < 3; ++c) {
                double off = 0.0;
                double spread = 0.0;
                int pixels = 0;
                for (int y = top; y < std::min(height, top + kTile); ++y)
                    for (int x = left; x < std::min(width, left + kTile); ++x) {
                        const auto i = static_cast<std::size_t>(y * width + x);
                        off += difference[i][c];
                        spread += variance[i][c];
                        ++pixels;
                    }
                const double rounding = pixels * kRounding;
                result.push_back(off / std::sqrt(spread + rounding * rounding));
            }
    return result;
}

double largestOf(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

}  // namespace

Agreement compare(const Moments& moments, int renders,
                  const std::function<raytracer::Image(int)>& render) {
    const std::size_t pixels = moments.mean.size();
    std::vector<Triple> sums(pixels);
    double expected = 0.0;
    for (std::size_t i = 0; i < pixels; ++i)
        expected += moments.covariance[i].rr + moments.covariance[i].gg + moments.covariance[i].bb;
    double total = 0.0;
    double total2 = 0.0;
    for (int number = 1; number <= renders; ++number) {
        const raytracer::Image image = render(number);
        double squares = 0.0;
        for (std::size_t i = 0; i < pixels; ++i) {
            const Triple value = triple(image.pixels()[i]);
            const Triple mean = triple(moments.mean[i]);
            for (std::size_t c = 0; c < 3; ++c) {
                sums[i][c] += value[c];
                squares += (value[c] - mean[c]) * (value[c] - mean[c]);
            }
        }
        total += squares;
        total2 += squares * squares;
    }
    std::vector<Triple> difference(pixels);
    std::vector<Triple> variance(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const Triple mean = triple(moments.mean[i]);
        const Triple error = triple(moments.meanError[i]);
        const Covariance& v = moments.covariance[i];
        const Triple own{v.rr, v.gg, v.bb};
        for (std::size_t c = 0; c < 3; ++c) {
            difference[i][c] = sums[i][c] / renders - mean[c];
            variance[i][c] = own[c] / renders + error[c];
        }
    }
    const std::vector<double> z = tileZ(moments.width, moments.height, difference, variance);
    Agreement agreement;
    agreement.largestZ = largestOf(z);
    for (const double value : z)
        agreement.meanZ2 += value * value / static_cast<double>(z.size());
    const double mean = total / renders;
    const double spread = std::sqrt(std::max(0.0, total2 / renders - mean * mean) / (renders - 1));
    agreement.varianceZ = std::abs(mean - expected) / spread;
    agreement.varianceRatio = mean / expected;
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

}  // namespace ticker::oracle::test
