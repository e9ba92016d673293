#ifndef TICKER_TASKS_DISTRIBUTED_SHADOWAIMS_H
#define TICKER_TASKS_DISTRIBUTED_SHADOWAIMS_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// A line may miss the ball by the shadow bias, where the direction was taken from the point
/// itself.
inline constexpr double kBiasAllowance = 1.5e-3;

/// How aim points lie in a light (docs/decisions/0003).
struct AimShape {
    enum class Radius {
        filling,  ///< the cube root of an even number, as in an evenly filled ball
        outer,    ///< on the surface
        even,
        root,  ///< the square root of an even number
        flat   ///< what looks like an evenly filled disc from everywhere, as the cone of a light
               ///< does
    };
    /// Where they crowd since the angle from there is drawn evenly, as in the original's helper.
    enum class Poles { none, x, y, z };

    Radius radius = Radius::filling;
    Poles poles = Poles::none;

    static const AimShape ball;
    static const AimShape surface;
    static const AimShape uniformRadius;
    static const AimShape rootRadius;
    static const AimShape flatDisc;      ///< as PBRT draws: evenly over the light's solid angle
    static const AimShape polarHelper;   ///< the original's
    static const AimShape polarHelperX;  ///< likewise, with poles along x
    static const AimShape polarHelperY;

    friend bool operator==(const AimShape&, const AimShape&) = default;
};

inline constexpr AimShape AimShape::ball{};
inline constexpr AimShape AimShape::surface{Radius::outer, Poles::none};
inline constexpr AimShape AimShape::uniformRadius{Radius::even, Poles::none};
inline constexpr AimShape AimShape::rootRadius{Radius::root, Poles::none};
inline constexpr AimShape AimShape::flatDisc{Radius::flat, Poles::none};
inline constexpr AimShape AimShape::polarHelper{Radius::even, Poles::z};
inline constexpr AimShape AimShape::polarHelperX{Radius::even, Poles::x};
inline constexpr AimShape AimShape::polarHelperY{Radius::even, Poles::y};

/// What is no worse than the original's helper is accepted, too, as that is: with a warning.
inline constexpr std::array kAcceptedAimShapes{
    AimShape::ball,
    AimShape::surface,
    AimShape::uniformRadius,
    AimShape::rootRadius,
    AimShape::flatDisc,
    AimShape::polarHelper,
    AimShape::polarHelperX,
    AimShape::polarHelperY,
    AimShape{AimShape::Radius::filling, AimShape::Poles::x},
    AimShape{AimShape::Radius::filling, AimShape::Poles::y},
    AimShape{AimShape::Radius::filling, AimShape::Poles::z},
    AimShape{AimShape::Radius::outer, AimShape::Poles::x},
    AimShape{AimShape::Radius::outer, AimShape::Poles::y},
    AimShape{AimShape::Radius::outer, AimShape::Poles::z}};

/// What the aim lines at far lights say. There lines are parallel but for 1 in 250, so that a
/// line's foot is its aim point as seen from afar, and nothing of it depends on the distance.
struct AimVerdict {
    bool tooWide = false;           ///< a line passes outside of the light
    bool tooNarrow = false;         ///< no line comes as near to the rim as some must
    bool huddled = false;           ///< too near to the centre for any eight aims
    bool offCentre = false;         ///< feet lean to one side
    std::optional<AimShape> shape;  ///< the accepted shape that fits at the right size
    bool between = false;           ///< there is none, but it lies between those that are accepted
    std::optional<AimShape>
        scaledShape;  ///< where there is none, or lines pass outside, what fits at the size seen
    double widest = 0.0;    ///< largest distance of a line from a centre, in radii of the light
    double rimShare = 0.0;  ///< share of lines beyond 0.9 of the widest
    double lean = 0.0;      ///< length of the mean foot, in radii
    bool together = false;  ///< the rays of one point go one way, or along one line
    std::size_t lines = 0;
    std::size_t distinct = 0;  ///< lines that can count as independent

    [[nodiscard]] bool sizeIsRight() const { return !tooWide && !tooNarrow; }
    [[nodiscard]] bool shapeIsRight() const { return shape || between; }
};

/// @param far  Logs of purpose farLight.
[[nodiscard]] AimVerdict judgeAims(const std::vector<const ShadowLog*>& far);

/// Point `i` of an even lattice of aims, for a light of radius 1 around the origin.
[[nodiscard]] Vector3 aimOf(AimShape shape, int i);

}  // namespace ticker::tasks

#endif
