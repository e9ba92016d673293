#include <grader/metrics/NoiseEnergy.h>

#include <algorithm>
#include <cmath>

namespace ticker::metrics {
namespace {

// Right programs differ by rounding even without noise. This is added to the denominator alone, so
// it only makes scores smaller.
constexpr double kRounding = 1.0;  // squared steps of a byte

double brightness(const ByteView& picture, std::size_t pixel) {
    const std::uint8_t* rgb = &picture.rgb[3 * pixel];
    return 0.25 * rgb[0] + 0.5 * rgb[1] + 0.25 * rgb[2];
}

double squaredScore(const ByteView& reference, const ByteView& test, int x0, int y0, int size) {
    double sum = 0.0;
    double squares = 0.0;
    for (int y = y0; y < std::min(y0 + size, test.height); ++y)
        for (int x = x0; x < std::min(x0 + size, test.width); ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(test.width) +
                           static_cast<std::size_t>(x);
            const double difference = brightness(test, i) - brightness(reference, i);
            sum += difference;
            squares += difference * difference + kRounding;
        }
    return sum * sum / squares;
}

}  // namespace

double NoiseEnergy::probability() const {
    if (energy <= tiles) return 1.0;
    return std::exp(0.5 * (tiles - energy + tiles * std::log(energy / tiles)));
}

NoiseEnergy noiseEnergy(const ByteView& reference, const ByteView& test, int tileSize) {
    requireSameSize(reference, test);
    NoiseEnergy result;
    for (int y = 0; y < test.height; y += tileSize)
        for (int x = 0; x < test.width; x += tileSize) {
            result.energy += squaredScore(reference, test, x, y, tileSize);
            ++result.tiles;
        }
    return result;
}

}  // namespace ticker::metrics
