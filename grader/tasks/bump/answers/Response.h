#ifndef TICKER_TASKS_BUMP_RESPONSE_H
#define TICKER_TASKS_BUMP_RESPONSE_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Ramps.h>

#include <array>
#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// Direction of the tilt for a slope along one axis of the map.
enum class Sense {
    right,     ///< away from the rising slope: raised
    inverted,  ///< towards the rising slope: lowered
    across,    ///< along the other axis
    dead,      ///< no tilt
    mixed      ///< none of these on the whole sphere
};

/// Shares of the points. They sum to 1, less the share of points with directions in between.
struct SenseShares {
    double right = 0.0;
    double inverted = 0.0;
    double across = 0.0;
    double dead = 0.0;
};

inline constexpr std::size_t kBands = 8;    ///< of polar angle, row 0 at the top
inline constexpr std::size_t kSectors = 8;  ///< of longitude

/// Response to slopes along one axis, over the whole sphere. Directions are angles: 0 is right, 180
/// degrees inverted, 90 degrees across.
struct AxisResponse {
    Sense sense = Sense::mixed;
    SenseShares shares;
    /// Number of bands in which the direction changes with the longitude.
    int bandsThatTurn = 0;
    /// Largest ratio of strengths between two sectors of longitude, after the dependence on
    /// latitude is divided out.
    double strengthRatio = 1.0;
    std::array<double, kBands> bandDirection{};  ///< degrees, -180 to 180
    std::array<double, kBands> bandStrength{};   ///< median length of the tilt
    Vector3 deadAt;                              ///< one point that is not tilted
    Vector3 deadFrom;                            ///< smallest components of such points
    Vector3 deadTo;                              ///< largest components of such points
    Vector3 worst;                ///< the point whose direction is farthest from right
    double worstDirection = 0.0;  ///< degrees

    /// -1 if the axis is inverted, 1 otherwise. Multiplied by it, tilts are as they should be.
    [[nodiscard]] double sign() const { return sense == Sense::inverted ? -1.0 : 1.0; }
};

/// Response matrix: mean tilt for each slope, in units of the mean length of the tilt on that ramp.
/// The identity is right. First index: the slope's axis; second: the tilt's axis.
using ResponseMatrix = std::array<std::array<double, 2>, 2>;

struct Response {
    AxisResponse u;
    AxisResponse v;
    ResponseMatrix matrix{};
    /// Degrees by which the tangents seem to be turned about the axis; 0 if no turn explains the
    /// tilts.
    double tangentTurn = 0.0;
    bool tangentsInDegrees = false;  ///< sines and cosines of angles in degrees explain the tilts

    /// The direction or the strength of the tilt changes with longitude.
    [[nodiscard]] bool dependsOnLongitude() const;
};

[[nodiscard]] Response measureResponse(const std::vector<RampTilts>& tilts,
                                       const Parametrisation& parametrisation);

/// Strength of the tilt at polar angle v, interpolated between the bands.
[[nodiscard]] double strengthAt(const AxisResponse& axis, double v);

}  // namespace ticker::tasks::bump

#endif
