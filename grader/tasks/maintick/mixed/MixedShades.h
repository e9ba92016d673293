#ifndef TICKER_TASKS_MAINTICK_MIXED_MIXEDSHADES_H
#define TICKER_TASKS_MAINTICK_MIXED_MIXEDSHADES_H

#include <grader/tasks/maintick/mixed/MixedPoints.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::tasks::maintick {

/// A light in front of the surface, and the object that hides it, if any.
struct Way {
    std::size_t light = 0;
    std::optional<int> blocker;  ///< the nearest object that hides it
};

/// A mixed point with objects before its lights, behind them and beside the way.
struct MixedShade {
    MixedPoint point;
    std::vector<Way> ways;  ///< of the lights in front of the surface
};

/// The questions of M3.2. No hit is within 0.012 of the light, of the point or of a tangent.
[[nodiscard]] std::vector<MixedShade> drawMixedShades(std::uint64_t seed);

/// The same point alone, without the lights that its own surface or an object hides; then with
/// these lights at intensity 0. Right code gives the same colour for both.
[[nodiscard]] LitSetup withoutHidden(const MixedShade& shade);
[[nodiscard]] LitSetup withHiddenOut(const MixedShade& shade);
/// The same without the lights that an object hides, but with those behind the surface: a shadow
/// ray that starts a bias along L is then below its own plane and does not hit it.
[[nodiscard]] LitSetup withoutBlocked(const MixedShade& shade);

/// The point with some of its lights: bit i is light i.
[[nodiscard]] LitSetup withLights(const LitSetup& setup, std::uint32_t bits);

}  // namespace ticker::tasks::maintick

#endif
