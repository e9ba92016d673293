#ifndef TICKER_TASKS_SHADOWS_CHECKS_SHADOWRAYCOUNTS_H
#define TICKER_TASKS_SHADOWS_CHECKS_SHADOWRAYCOUNTS_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// Largest accepted distance of a ray's start from the lit point: biases from 1e-6 to 1e-3, and
/// half as much again for a step along both N and L.
inline constexpr double kLargestBias = 1.5e-3;

/// Distance of a ray's start from the lit point.
[[nodiscard]] double biasOf(const AimLine& line, const PointLog& point);

/// Number of rays that differ in origin or direction; each added one counts.
[[nodiscard]] std::size_t distinctRays(const std::vector<AimLine>& lines);

/// Counts over all points and those of their lights that the surface faces.
struct RayCounts {
    std::size_t fewest = static_cast<std::size_t>(-1);
    std::size_t fewestDistinct = static_cast<std::size_t>(-1);
    std::size_t most = 0;
    std::size_t mostDistinct = 0;
    std::size_t places = 0;     ///< points times lights
    std::size_t repeating = 0;  ///< places at which some rays are equal
    bool allCentral = true;     ///< every ray goes to its light's centre

    /// Whether rays are reused, beyond the rare repetition of a coarse generator.
    [[nodiscard]] bool repeats(std::size_t asked) const {
        return fewestDistinct <= asked / 2 || 10 * repeating > places;
    }
};
/// @param lightsWithoutRays  Whether a light without any ray counts, with zero.
[[nodiscard]] RayCounts countRays(const std::vector<const ShadowLog*>& logs,
                                  bool lightsWithoutRays = true);

/// Largest distance of a ray's line from its light's centre.
[[nodiscard]] double widestMiss(const std::vector<const ShadowLog*>& logs);

}  // namespace ticker::tasks

#endif
