#ifndef TICKER_TASKS_BUMP_RESPONSE_H
#define TICKER_TASKS_BUMP_RESPONSE_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Ramps.h>

#include <array>
#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// How the tilt answers a slope along one axis of the map.
enum class Sense {
    right,     ///< leans back against the slope: raised
    inverted,  ///< leans into the slope: lowered
    across,    ///< leans along the other axis
    dead,      ///< does not answer
    mixed      ///< none of these everywhere
};

/// Shares of the points, which sum to 1 but for directions in between.
struct SenseShares {
    double right = 0.0;
    double inverted = 0.0;
    double across = 0.0;
    double dead = 0.0;
};

inline constexpr std::size_t kBands = 8;    ///< of polar angle, row 0 at the top
inline constexpr std::size_t kSectors = 8;  ///< of longitude

/// One axis over the whole sphere. Directions are angles: 0 right, a half turn inverted, a quarter
/// turn across.
struct AxisResponse {
    Sense sense = Sense::mixed;
    SenseShares shares;
    /// Bands in which sectors of longitude disagree about the direction.
    int bandsThatTurn = 0;
    /// The largest ratio between the strengths in two sectors of longitude, latitude allowed for.
    double strengthRatio = 1.0;
    std::array<double, kBands> bandDirection{};  ///< degrees, -180 to 180
    std::array<double, kBands> bandStrength{};   ///< middle length of the tilt
    Vector3 deadAt;                              ///< a point that is not tilted
    Vector3 deadFrom;                            ///< least components of such points
    Vector3 deadTo;                              ///< and largest
    Vector3 worst;                               ///< where the direction is farthest from right
    double worstDirection = 0.0;                 ///< degrees

    /// -1 where it is inverted, else 1: times this, tilts are as they should be.
    [[nodiscard]] double sign() const { return sense == Sense::inverted ? -1.0 : 1.0; }
};

/// The response matrix: mean tilt against the slope, in units of the mean length of the tilt on
/// that ramp; the identity is right. First index: the slope's axis; second: the tilt's.
using ResponseMatrix = std::array<std::array<double, 2>, 2>;

struct Response {
    AxisResponse u;
    AxisResponse v;
    ResponseMatrix matrix{};
    /// Degrees by which the tangents seem to be turned about the axis; 0 where no such turn
    /// explains the tilts.
    double tangentTurn = 0.0;
    bool tangentsInDegrees = false;  ///< sines and cosines of degrees explain the tilts

    /// The direction or the strength of the tilt changes round the sphere.
    [[nodiscard]] bool dependsOnLongitude() const;
};

[[nodiscard]] Response measureResponse(const std::vector<RampTilts>& tilts,
                                       const Parametrisation& parametrisation);

/// The strength of the tilt at a polar angle, from the bands' middle values.
[[nodiscard]] double strengthAt(const AxisResponse& axis, double v);

}  // namespace ticker::tasks::bump

#endif
