#ifndef TICKER_TASKS_DISTRIBUTED_SHADOWREPLAY_H
#define TICKER_TASKS_DISTRIBUTED_SHADOWREPLAY_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// One accepted way to turn shadow rays into a colour.
struct ShadowReading {
    enum class Phong {
        central,             ///< one L, to the centre, times the share of rays that arrive
        centralFalloff,      ///< one L, light falling off over the distance of each sample
        perSampleDirection,  ///< a term for each ray that arrives, light as bright as its centre
        perSample            ///< the same, light falling off over the distance of the sample
    };
    Phong phong = Phong::central;
    bool viewerIsEye = false;     ///< V towards the world's origin instead of O
    bool withoutCentral = false;  ///< rays to the very centre are not counted (an extra hard ray)
    bool termsApart = false;      ///< rays are cast for the diffuse and again for the specular term
};

/// What may be done with the shares: `right`, or a mistake with a name of its own.
enum class ShadowArithmetic {
    right,
    inverted,
    ambientScaled,
    ambientForEachLight,
    specularUnshadowed,
    specularIfAny,  ///< the specular term in full as soon as one ray arrives
    diffuseUnshadowed,
    endless,   ///< what stands behind the light counts
    litIfAll,  ///< all or nothing
    litIfAny,
    litIfHalf
};

/// Recomputes the colour of a point from its logged rays and compares.
/// Rays that rounding decides give an interval, and so does the unknown place of a sample on its
/// line; a colour fits when it lies in it.
[[nodiscard]] bool fits(const PointLog& point, const raytracer::SceneDescription& scene,
                        const raytracer::RenderSettings& settings, const ShadowReading& reading,
                        ShadowArithmetic arithmetic);

/// Counts how many of some points fit.
struct FitCount {
    std::size_t fitting = 0;
    std::size_t points = 0;
    [[nodiscard]] bool all() const { return fitting == points; }
};
[[nodiscard]] FitCount countFits(const ShadowLog& log, const ShadowReading& reading,
                                 ShadowArithmetic arithmetic);

/// Every accepted reading, the reference solution's first.
[[nodiscard]] std::vector<ShadowReading> acceptedShadowReadings();

/// What a light would add to a point in full light, by the central reading.
[[nodiscard]] ColourRGB unshadowed(const PointLog& point, const raytracer::SceneDescription& scene,
                                   std::size_t light, bool viewerIsEye);

/// The ambient part of a point's colour.
[[nodiscard]] ColourRGB ambientPart(const PointLog& point,
                                    const raytracer::SceneDescription& scene);

/// How far two colours of this point may differ without meaning anything.
[[nodiscard]] ColourRGB toleranceAt(const PointLog& point, const raytracer::SceneDescription& scene,
                                    bool viewerIsEye);

}  // namespace ticker::tasks

#endif
