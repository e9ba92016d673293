#ifndef TICKER_DECISION_DISTRIBUTED_SHADOWAIMS_H
#define TICKER_DECISION_DISTRIBUTED_SHADOWAIMS_H

#include <grader/decision/distributed/ShadowLog.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::decision {

/// Accepted ways in which aim points lie in a light (design, section 5.3).
enum class AimShape {
    ball,
    surface,
    uniformRadius,
    polarHelper,   ///< poles along z, as the original's helper has them
    polarHelperX,  ///< along x
    polarHelperY,  ///< along y
};

inline constexpr std::array kAcceptedAimShapes{AimShape::ball,          AimShape::surface,
                                               AimShape::uniformRadius, AimShape::polarHelper,
                                               AimShape::polarHelperX,  AimShape::polarHelperY};

/// Whether points crowd at the centre and at two poles, wherever those lie.
[[nodiscard]] constexpr bool crowdsAtPoles(AimShape shape) {
    return shape == AimShape::polarHelper || shape == AimShape::polarHelperX ||
           shape == AimShape::polarHelperY;
}

/// What the aim lines at far lights say. There lines are parallel but for 1 in 250, so that a
/// line's foot is its aim point as seen from afar, and nothing of it depends on the distance.
struct AimVerdict {
    bool tooWide = false;                 ///< a line passes outside of the light
    bool tooNarrow = false;               ///< no line comes as near to the rim as some must
    bool huddled = false;                 ///< too near to the centre for any eight aims
    bool offCentre = false;               ///< feet lean to one side
    std::optional<AimShape> shape;        ///< the accepted shape that fits at the right size
    std::optional<AimShape> scaledShape;  ///< the one that fits at the size that was seen
    double widest = 0.0;    ///< largest distance of a line from a centre, in radii of the light
    double rimShare = 0.0;  ///< share of lines beyond 0.9 of the widest
    double lean = 0.0;      ///< length of the mean foot, in radii
    bool together = false;  ///< the rays of one point go one way, or along one line
    std::size_t lines = 0;
    std::size_t distinct = 0;  ///< lines that can count as independent

    [[nodiscard]] bool sizeIsRight() const { return !tooWide && !tooNarrow; }
};

/// @param far  Logs of purpose farLight.
[[nodiscard]] AimVerdict judgeAims(const std::vector<const ShadowLog*>& far);

/// Point `i` of an even lattice of aims, for a light of radius 1 around the origin.
[[nodiscard]] Vector3 aimOf(AimShape shape, int i);

}  // namespace ticker::decision

#endif
