#ifndef TICKER_TASKS_MAINTICK_MIXED_MIXEDMIRRORS_H
#define TICKER_TASKS_MAINTICK_MIXED_MIXEDMIRRORS_H

#include <grader/tasks/maintick/mixed/MirrorLinks.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks::maintick {

/// A ray that meets each mirror from its front, well off all edges.
struct MixedMirror {
    raytracer::SceneDescription scene;
    Ray ray;
    std::vector<MirrorLink> links;  ///< at most `kMostLinks`; after fewer the ray meets nothing
};

/// The questions of M4. The direct light of each surface hardly depends on where a mirrored ray
/// starts, so that every accepted bias gives the same answers.
[[nodiscard]] std::vector<MixedMirror> drawMixedMirrors(std::uint64_t seed);

/// What trace gives with this many bounces left.
/// @param direct  Of each link.
[[nodiscard]] ColourRGB alongLinks(const MixedMirror& mirror, const std::vector<ColourRGB>& direct,
                                   int bounces);

}  // namespace ticker::tasks::maintick

#endif
