#ifndef TICKER_TASKS_BUMP_REPLIES_H
#define TICKER_TASKS_BUMP_REPLIES_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Response.h>

#include <raytracer/math/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ticker::tasks::bump {

/// A point at which the tilt must follow the slope.
struct Reply {
    Vector3 direction;
    double u = 0.0;
    double v = 0.0;
    Vector3 alongSlope;  // unit tangent along which the ramp rises
    Vector3 across;      // the map's other unit tangent
    Vector3 tilt;

    /// Part of the tilt away from the rising slope: positive if bright texels are raised.
    [[nodiscard]] double towards() const { return -tilt.dot(alongSlope); }
    /// Part of the tilt across the slope.
    [[nodiscard]] double sideways() const { return -tilt.dot(across); }
    /// Direction of the tilt, radians: 0 is right, pi inverted.
    [[nodiscard]] double angle() const { return std::atan2(sideways(), towards()); }
    [[nodiscard]] std::size_t band() const {
        return std::min(kBands - 1, static_cast<std::size_t>(v * kBands));
    }
    [[nodiscard]] std::size_t sector() const {
        return std::min(kSectors - 1, static_cast<std::size_t>(u * kSectors));
    }
};

/// The replies on both ramps.
struct Replies {
    std::vector<Reply> onU;
    std::vector<Reply> onV;
};

// Coarse finite-difference tangents, and tangents at the texel instead of the point, turn a right
// tilt by up to 6 degrees on these maps.
inline constexpr double kSenseTolerance = 15.0 * std::numbers::pi / 180.0;

/// True if two angles agree within `kSenseTolerance`.
[[nodiscard]] inline bool near(double angle, double target) {
    return std::abs(std::remainder(angle - target, 2.0 * std::numbers::pi)) <= kSenseTolerance;
}

/// Sets the fields of `response` that name the wrong tangents: of another longitude, or of angles
/// in degrees.
void explainTangents(const Replies& replies, const Parametrisation& parametrisation,
                     Response& response);

}  // namespace ticker::tasks::bump

#endif
