#ifndef TICKER_TASKS_MAINTICK_TRACEMODEL_H
#define TICKER_TASKS_MAINTICK_TRACEMODEL_H

#include <grader/tasks/maintick/Exact.h>
#include <grader/tasks/support/Background.h>

#include <optional>
#include <span>
#include <vector>

namespace ticker::tasks::maintick {

/// The nearest object on a ray.
struct NearestObject {
    int object = 0;  ///< spheres first, then planes
    Meeting meeting;
};
[[nodiscard]] std::optional<NearestObject> nearestOn(const raytracer::SceneDescription& scene,
                                                     const Ray& ray);

/// Where a reflected ray starts: along the normal, or along the ray.
struct MirrorStart {
    double bias = 1e-4;
    bool isAlongRay = false;
};

/// The objects that a ray meets one after the other, at most `most`.
[[nodiscard]] std::vector<int> chainOf(const raytracer::SceneDescription& scene, Ray ray, int most,
                                       const MirrorStart& start);

/// What is blended at a mirror.
struct MirrorColours {
    ColourRGB own;  ///< direct light
    ColourRGB seen;
    double share = 0.0;   ///< of `seen`
    double before = 1.0;  ///< the share of the mirror before it
    ColourRGB tint;       ///< the colour of the mirror's material
};

/// How `trace` works. The defaults are right; each known mistake changes some of them.
struct TraceWay {
    ColourRGB background = kBackground;
    ColourRGB mirroredBackground = kBackground;
    bool isDirectWhereNothingIsSeen = false;  ///< direct light alone if the mirrored ray misses
    Vector3 (*mirrored)(const Vector3& D, const Vector3& N) =
        [](const Vector3& D, const Vector3& N) { return (-D).reflectIn(N); };
    double bias = 1e-4;
    bool startsAtOrigin = false;
    int last = 0;           ///< bounces left at which no mirror counts any more
    int spent = 1;          ///< bounces for each mirror
    int most = 1000;        ///< at most this many bounces are left behind a mirror
    double weakest = 0.0;   ///< share below which no mirror counts
    bool endsDark = false;  ///< direct light times 1 - share where no mirror counts
    ColourRGB (*blend)(const MirrorColours&) = [](const MirrorColours& at) {
        return at.own * (1.0 - at.share) + at.seen * at.share;
    };
};

/// A known mistake: its name, how `trace` works with it, and what mends it.
struct TraceMistake {
    const FindingText* finding;
    TraceWay way;
    const char* hint = "";  ///< empty: that of `finding`
};

/// Surfaces that show nothing but their direct light.
[[nodiscard]] const TraceMistake& noMirrors();
/// The other known mistakes of M4. The first one that explains all answers is named.
[[nodiscard]] std::span<const TraceMistake> traceMistakes();

/// What trace gives in a scene in which each object has one colour, wherever it is seen.
struct TraceModel {
    const raytracer::SceneDescription& scene;
    const std::vector<ColourRGB>& direct;  ///< of each object
    TraceWay way = {};

    /// @param before  The share of the mirror that the ray comes from; 1: of none.
    [[nodiscard]] ColourRGB along(const Ray& ray, int bounces, int depth = 0,
                                  double before = 1.0) const;
};

}  // namespace ticker::tasks::maintick

#endif
