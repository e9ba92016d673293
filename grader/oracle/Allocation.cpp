#include <grader/oracle/Allocation.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace ticker::oracle {
namespace {

// Blends each pixel's variance with the mean over its 3 x 3 neighbourhood and a little of the whole
// picture's: a pilot of few paths may agree by chance, which must not count as no noise.
std::vector<double> smoothed(const PilotNoise& pilot) {
    constexpr double kShareOfWhole = 0.02;
    const double whole = std::accumulate(pilot.variance.begin(), pilot.variance.end(), 0.0) /
                         static_cast<double>(pilot.variance.size());
    std::vector<double> result(pilot.variance.size());
    for (int y = 0; y < pilot.height; ++y) {
        for (int x = 0; x < pilot.width; ++x) {
            double sum = 0.0;
            int count = 0;
            for (int v = std::max(0, y - 1); v <= std::min(pilot.height - 1, y + 1); ++v)
                for (int u = std::max(0, x - 1); u <= std::min(pilot.width - 1, x + 1); ++u) {
                    sum += pilot.variance[static_cast<std::size_t>(v * pilot.width + u)];
                    ++count;
                }
            result[static_cast<std::size_t>(y * pilot.width + x)] =
                sum / count + kShareOfWhole * whole;
        }
    }
    return result;
}

std::uint32_t powerOfTwoNear(double value, std::uint32_t least, std::uint32_t most) {
    const double bounded = std::clamp(value, static_cast<double>(least), static_cast<double>(most));
    const auto exponent = static_cast<int>(std::lround(std::log2(bounded)));
    return std::clamp(std::uint32_t{1} << exponent, std::bit_ceil(least), std::bit_floor(most));
}

}  // namespace

std::vector<std::uint32_t> allocated(const PilotNoise& pilot, int replicates, double target,
                                     std::uint32_t least, std::uint32_t most, bool even) {
    const std::vector<double> noise = smoothed(pilot);
    // Least cost: all pixels have the same derivative of variance by number of paths.
    const double exponent = even ? 0.0 : 1.0 / (1.0 + pilot.decay);
    std::vector<std::uint32_t> counts(noise.size(), least);
    for (double scale = 1.0; scale < 1e12; scale *= 1.1) {
        double predicted = 0.0;
        bool full = true;
        for (std::size_t i = 0; i < noise.size(); ++i) {
            const double relative = std::pow(noise[i] / (target + 1e-300), exponent);
            counts[i] = powerOfTwoNear(scale * relative, least, most);
            full = full && counts[i] >= std::bit_floor(most);
            predicted +=
                noise[i] * std::pow(static_cast<double>(pilot.paths) / counts[i], pilot.decay);
        }
        if (predicted / replicates <= target || full) break;
    }
    return counts;
}

}  // namespace ticker::oracle
