#ifndef TICKER_TASKS_MAINTICK_MIXED_MIXEDMIRRORS_H
#define TICKER_TASKS_MAINTICK_MIXED_MIXEDMIRRORS_H

#include <grader/tasks/maintick/mixed/MirrorLinks.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks::maintick {

/// A ray of which each mirror is met from its front, well off all edges.
struct MixedMirror {
    raytracer::SceneDescription scene;
    Ray ray;
    std::vector<MirrorLink> links;  ///< as many as four bounces meet; fewer: then comes nothing
};

/// The questions of M4. Lights, where there are any, change so little along with where a mirrored
/// ray starts that no bias shows.
[[nodiscard]] std::vector<MixedMirror> drawMixedMirrors(std::uint64_t seed);

/// What trace gives with this many bounces left.
/// @param direct  Of each link.
[[nodiscard]] ColourRGB alongLinks(const MixedMirror& mirror, const std::vector<ColourRGB>& direct,
                                   int bounces);

}  // namespace ticker::tasks::maintick

#endif
