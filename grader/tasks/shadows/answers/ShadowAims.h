#ifndef TICKER_TASKS_SHADOWS_ANSWERS_SHADOWAIMS_H
#define TICKER_TASKS_SHADOWS_ANSWERS_SHADOWAIMS_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// A line may miss the ball by the shadow bias, if its direction was computed from the point
/// itself.
inline constexpr double kBiasAllowance = 1.5e-3;

/// Distribution of aim points in a light (docs/decisions/0003).
struct AimShape {
    enum class Radius {
        filling,  ///< cube root of a uniform number, as in an evenly filled ball
        outer,    ///< on the surface
        uniform,  ///< a uniform number, so that the aims are denser in the middle
        root,     ///< square root of a uniform number
        flat      ///< looks like an evenly filled disc from everywhere, as uniform sampling of the
                  ///< light's solid angle does
    };
    /// Axis on whose poles samples crowd because the polar angle is uniform, as in the original's
    /// helper.
    enum class Poles { none, x, y, z };

    Radius radius = Radius::filling;
    Poles poles = Poles::none;

    static const AimShape ball;
    static const AimShape surface;
    static const AimShape uniformRadius;
    static const AimShape rootRadius;
    static const AimShape flatDisc;      ///< evenly over the light's solid angle, as in PBRT
    static const AimShape polarHelper;   ///< the original's helper
    static const AimShape polarHelperX;  ///< the helper with poles along x
    static const AimShape polarHelperY;

    friend bool operator==(const AimShape&, const AimShape&) = default;
};

inline constexpr AimShape AimShape::ball{};
inline constexpr AimShape AimShape::surface{Radius::outer, Poles::none};
inline constexpr AimShape AimShape::uniformRadius{Radius::uniform, Poles::none};
inline constexpr AimShape AimShape::rootRadius{Radius::root, Poles::none};
inline constexpr AimShape AimShape::flatDisc{Radius::flat, Poles::none};
inline constexpr AimShape AimShape::polarHelper{Radius::uniform, Poles::z};
inline constexpr AimShape AimShape::polarHelperX{Radius::uniform, Poles::x};
inline constexpr AimShape AimShape::polarHelperY{Radius::uniform, Poles::y};

/// Shapes with poles are no worse than the original's helper, and are accepted like it: with a
/// warning.
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

/// Result of the aim lines at far lights. Lines there are parallel within 1 in 250: a line's foot
/// is its aim point seen from afar, and does not depend on the distance.
struct AimVerdict {
    bool tooWide = false;    ///< a line passes outside of the light
    bool tooNarrow = false;  ///< no line comes as near to the rim as some line must
    bool huddled = false;    ///< all lines are too near to the centre for eight independent aims
    bool offCentre = false;  ///< the feet have a mean off the centre
    std::optional<AimShape> shape;  ///< the accepted shape that fits at the right size
    bool between = false;           ///< no shape fits, but the density lies between accepted ones
    std::optional<AimShape> scaledShape;  ///< the shape that fits at the observed size; if `shape`
                                          ///< is empty or lines pass outside
    double widest = 0.0;    ///< largest distance of a line from a centre, in radii of the light
    double rimShare = 0.0;  ///< share of lines beyond 0.9 of the widest
    double lean = 0.0;      ///< length of the mean foot, in radii
    bool together = false;  ///< the rays of one point go one way, or along one line
    bool turnsWithViewer = false;  ///< the shape faces the viewer O
    std::size_t lines = 0;
    std::size_t distinct = 0;  ///< number of lines that count as independent

    [[nodiscard]] bool sizeIsRight() const { return !tooWide && !tooNarrow; }
    [[nodiscard]] bool shapeIsRight() const { return (shape || between) && !turnsWithViewer; }
};

/// @param far  Logs of purpose farLight.
[[nodiscard]] AimVerdict judgeAims(const std::vector<const ShadowLog*>& far);

/// Point `i` of an even lattice of aims, for a light of radius 1 at the origin.
[[nodiscard]] Vector3 aimOf(AimShape shape, int i);

/// The first `count` points of this lattice. They are computed once and kept: every decision uses
/// the same.
[[nodiscard]] const std::vector<Vector3>& aimsOf(AimShape shape, int count);

}  // namespace ticker::tasks

#endif
