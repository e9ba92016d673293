#ifndef TICKER_TASKS_SHADOWS_ANSWERS_SHADOWREPLAY_H
#define TICKER_TASKS_SHADOWS_ANSWERS_SHADOWREPLAY_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace ticker::tasks {

/// One accepted way to compute a colour from shadow rays.
struct ShadowReading {
    enum class Phong {
        central,             ///< one L, to the centre, times the share of rays that arrive
        centralFalloff,      ///< one L; falloff with the distance of each sample
        perSampleDirection,  ///< a term for each ray that arrives; falloff with the distance of the
                             ///< centre
        perSample  ///< a term for each ray that arrives; falloff with the distance of the sample
    };
    Phong phong = Phong::central;
    bool viewerIsEye = false;     ///< V points to the world's origin instead of O
    bool withoutCentral = false;  ///< rays to the exact centre are not counted (an extra hard ray)
    /// Rays of the diffuse and of the specular term: the same, the first and the second half, or in
    /// turns.
    enum class Terms { together, halves, inTurns };
    Terms terms = Terms::together;
    /// Every sample lies on the half of the light's surface that faces the point. Not set in
    /// acceptedShadowReadings, whose readings with the distance of each sample include this case.
    bool nearSide = false;
    /// If each term has rays of its own, those of the specular term come first: the compiler
    /// chooses the order in which it evaluates a + b.
    bool specularFirst = false;
};

/// What the code does with the shares: `right`, or a named mistake.
enum class ShadowArithmetic {
    right,
    inverted,
    ambientScaled,
    ambientForEachLight,
    specularUnshadowed,
    specularIfAny,  ///< the specular term in full as soon as one ray arrives
    diffuseUnshadowed,
    endless,   ///< objects behind the light block rays
    litIfAll,  ///< all or nothing
    litIfAny,
    litIfHalf,
    meanOverArrived  ///< the sum is divided by the number of rays that arrive
};

/// Recomputes the colour of a point from its logged rays and compares. Rays that rounding decides
/// give an interval, and so does the unknown place of a sample on its line. A colour fits if it
/// lies in the interval.
[[nodiscard]] bool fits(const PointLog& point, const raytracer::SceneDescription& scene,
                        const raytracer::RenderSettings& settings, const ShadowReading& reading,
                        ShadowArithmetic arithmetic);

/// Number of points that fit.
struct FitCount {
    std::size_t fitting = 0;
    std::size_t points = 0;
};
[[nodiscard]] FitCount countFits(const ShadowLog& log, const ShadowReading& reading,
                                 ShadowArithmetic arithmetic);

/// Whether all points fit: faster than counting, because it ends at the first that does not.
[[nodiscard]] bool allFit(const ShadowLog& log, const ShadowReading& reading,
                          ShadowArithmetic arithmetic);

/// All accepted readings, the reference solution's first.
[[nodiscard]] std::vector<ShadowReading> acceptedShadowReadings();

/// Whether all points fit one of them.
[[nodiscard]] bool fitsAnyReading(const ShadowLog& log);

/// Light of one lamp at a point without shadow, in the central reading.
[[nodiscard]] ColourRGB unshadowed(const PointLog& point, const raytracer::SceneDescription& scene,
                                   std::size_t light, bool viewerIsEye);

/// The ambient part of a point's colour.
[[nodiscard]] ColourRGB ambientPart(const PointLog& point,
                                    const raytracer::SceneDescription& scene);

/// Tolerance for the difference between two colours of this point.
[[nodiscard]] ColourRGB toleranceAt(const PointLog& point, const raytracer::SceneDescription& scene,
                                    bool viewerIsEye);

}  // namespace ticker::tasks

#endif
