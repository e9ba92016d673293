#include <grader/oracle/Allocation.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace ticker::oracle {
namespace {

// Blends each pixel's variance with the mean over its 3 x 3 neighbourhood and a little of the whole
// picture's: the few pilot paths of a pixel may agree by chance, and the pixel must not count as
// free of noise then.
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

// Rounds the base-2 logarithm of a pixel's number of paths. Each pixel is rounded dozens of times;
// with logarithms that needs neither std::pow nor std::log2.
int roundedTo(double wish, int least, int most) {
    return static_cast<int>(
        std::lround(std::clamp(wish, static_cast<double>(least), static_cast<double>(most))));
}

// Share of the pilot's variance that remains, by the base-2 logarithm of the number of paths.
std::array<double, 32> remainders(const PilotNoise& pilot) {
    std::array<double, 32> result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = std::pow(std::ldexp(pilot.paths, -static_cast<int>(i)), pilot.decay);
    return result;
}

}  // namespace

std::vector<std::uint32_t> allocated(const PilotNoise& pilot, int replicates, double target,
                                     std::uint32_t least, std::uint32_t most, bool even) {
    const std::vector<double> noise = smoothed(pilot);
    const std::array<double, 32> remaining = remainders(pilot);
    const int lowest = std::countr_zero(std::bit_ceil(least));
    const int highest = std::max(lowest, std::countr_zero(std::bit_floor(most)));
    // Least cost: all pixels have the same derivative of variance by number of paths.
    std::vector<double> wishes;
    for (const double variance : noise)
        wishes.push_back(even ? 0.0
                              : std::log2(variance / (target + 1e-300)) / (1.0 + pilot.decay));
    std::vector<std::uint32_t> counts(noise.size(), least);
    constexpr double kStep = 0.1375;  // log2(1.1): a tenth more paths
    for (double more = 0.0; more < 40.0; more += kStep) {
        double predicted = 0.0;
        int fewest = highest;
        for (std::size_t i = 0; i < noise.size(); ++i) {
            const int paths = roundedTo(more + wishes[i], lowest, highest);
            counts[i] = std::uint32_t{1} << static_cast<unsigned>(paths);
            fewest = std::min(fewest, paths);
            predicted += noise[i] * remaining[static_cast<std::size_t>(paths)];
        }
        if (predicted / replicates <= target || fewest == highest) break;
    }
    return counts;
}

}  // namespace ticker::oracle
