#ifndef TICKER_TASKS_MAINTICK_TRACEMODEL_H
#define TICKER_TASKS_MAINTICK_TRACEMODEL_H

#include <grader/tasks/maintick/Exact.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace ticker::tasks::maintick {

/// Known mistakes in trace; `none` is the right one.
enum class TraceMistake : std::uint8_t {
    none,
    noMirror,
    black,
    blackMirrored,
    directWhereMirroredMisses,
    notNegated,
    straightOn,
    straightBack,
    alongNormal,
    startAtOrigin,
    startBelow,
    notLowered,
    oneLess,
    oneMore,
    once,
    plusWhole,
    sharesExchanged,
    wholeDirect,
    wholeMirrored,
    directLost,
    mirroredAlone,
    evenShares,
    timesColour,
    baseReduced,
    weakIgnored,     ///< mirrors below 0.1
    weightReplaced,  ///< a loop that forgets the shares of all mirrors but the last
    kCount
};

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

/// What trace gives in a scene in which each object has one colour, wherever it is seen.
struct TraceModel {
    const raytracer::SceneDescription& scene;
    const std::vector<ColourRGB>& direct;  ///< of each object
    TraceMistake mistake = TraceMistake::none;

    [[nodiscard]] ColourRGB along(const Ray& ray, int bounces, int depth = 0) const;

private:
    [[nodiscard]] ColourRGB blend(int object, const ColourRGB& mirrored) const;
    [[nodiscard]] ColourRGB withReplacedWeight(Ray ray, int bounces) const;
};

/// The objects that a ray meets one after the other, at most `most`.
[[nodiscard]] std::vector<int> chainOf(const raytracer::SceneDescription& scene, Ray ray, int most,
                                       const MirrorStart& start);

}  // namespace ticker::tasks::maintick

#endif
