#ifndef TICKER_TASKS_MAINTICK_MIXED_MIRRORLINKS_H
#define TICKER_TASKS_MAINTICK_MIXED_MIRRORLINKS_H

#include <grader/tasks/maintick/TraceModel.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::maintick {

/// A surface on the way of a ray through mirrors.
struct MirrorLink {
    int object = 0;
    double share = 0.0;  ///< its reflectivity
    Vector3 P;
    Vector3 N;
    Vector3 O;  ///< where the ray to it starts
};

inline constexpr int kMostMixedBounces = 4;
inline constexpr std::size_t kMostLinks = kMostMixedBounces + 1;

/// The links of a ray whose mirrored rays start like this, at most `kMostLinks`.
[[nodiscard]] std::vector<MirrorLink> linksOf(const raytracer::SceneDescription& scene, Ray ray,
                                              const MirrorStart& start);

/// The light of each link by our own `illuminate`, shadows included.
[[nodiscard]] std::vector<ColourRGB> directOf(const raytracer::SceneDescription& scene,
                                              const std::vector<MirrorLink>& links);

/// Whether every mirror is met from its front, and nothing is near the way.
[[nodiscard]] bool areOffEdges(const raytracer::SceneDescription& scene, const Ray& ray,
                               const std::vector<MirrorLink>& links);

/// Whether each light is off the edges of all surfaces.
[[nodiscard]] bool areLightsClear(const raytracer::SceneDescription& scene,
                                  const std::vector<MirrorLink>& links);

/// Whether the chain and its light stay the same wherever the mirrored rays start, from 1e-6 to
/// twice the largest bias.
[[nodiscard]] bool isSteady(const raytracer::SceneDescription& scene, const Ray& ray,
                            const std::vector<MirrorLink>& links);

}  // namespace ticker::tasks::maintick

#endif
