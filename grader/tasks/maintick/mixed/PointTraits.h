#ifndef TICKER_TASKS_MAINTICK_MIXED_POINTTRAITS_H
#define TICKER_TASKS_MAINTICK_MIXED_POINTTRAITS_H

#include <grader/tasks/maintick/mixed/Edges.h>
#include <grader/tasks/maintick/mixed/MixedPoints.h>
#include <grader/tasks/support/Channels.h>

#include <algorithm>

namespace ticker::tasks::maintick {

// What sets points, lights and surfaces apart.

[[nodiscard]] inline bool isBlack(const ColourRGB& c) {
    return largestChannel(c) == 0.0;
}
[[nodiscard]] inline bool hasBlackChannel(const ColourRGB& c) {
    return !isBlack(c) && std::min({c.r, c.g, c.b}) == 0.0;
}

[[nodiscard]] inline const raytracer::Material& ownMaterialOf(const LitSetup& setup) {
    return setup.scene.spheres[0].material;
}

[[nodiscard]] inline double distanceOf(const LitSetup& setup, const raytracer::PointLight& light) {
    return (light.position() - setup.P).magnitude();
}
[[nodiscard]] inline double arrivingOf(const LitSetup& setup, const raytracer::PointLight& light) {
    return largestChannel(light.illuminationAt(distanceOf(setup, light)));
}

// Limits of what the traits call near, far, faint, bright and low. Distances are in world units;
// light is what arrives of it in its brightest channel.
inline constexpr double kLightNear = 1.0;
inline constexpr double kLightFar = 15.0;
inline constexpr double kArrivesFaint = 1.0 / 255.0;
inline constexpr double kArrivesBright = 2.0;
inline constexpr double kFacingLow = 0.12;  ///< N.L
inline constexpr double kPlaceFar = 20.0;

[[nodiscard]] inline bool isFaint(const LitSetup& s, const raytracer::PointLight& light) {
    return arrivingOf(s, light) < kArrivesFaint;
}
[[nodiscard]] inline bool isLow(const LitSetup& s, const raytracer::PointLight& light) {
    return facingOf(s, light) > 0.0 && facingOf(s, light) < kFacingLow;
}

/// Whether one of the lights is like this.
template <class Fits>
[[nodiscard]] bool anyLight(const LitSetup& setup, const Fits& fits) {
    return std::ranges::any_of(setup.scene.pointLights, [&](const raytracer::PointLight& light) {
        return fits(setup, light);
    });
}

}  // namespace ticker::tasks::maintick

#endif
