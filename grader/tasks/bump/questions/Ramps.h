#ifndef TICKER_TASKS_BUMP_RAMPS_H
#define TICKER_TASKS_BUMP_RAMPS_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// Size and steepness of a set of ramps.
struct RampShape {
    int columns = 2080;     ///< of ramps along u
    int rows = 1536;        ///< of ramps along v
    int across = 96;        ///< texels at a right angle to the slope
    double rise = 5.0;      ///< height difference between the ends
    double base = 0.0;      ///< height of the lowest texel
    int bytesPerTexel = 0;  ///< not 0: a slope in whole bytes, from 128 to 255 again and again

    /// Height per texel of a ramp that is `texels` long.
    [[nodiscard]] double slope(int texels) const {
        return bytesPerTexel == 0 ? rise / (texels - 1) : kByte * bytesPerTexel;
    }
};

/// Six questions at the same points of the same sphere, three along u and three along v: a ramp, a
/// bow (a parabola with the ramp's slope at its start, which falls from the middle on) and a flat
/// map of their size.
struct RampPlan {
    RampShape shape;
    std::vector<Vector3> directions;
    std::size_t uFlat = 0;
    std::size_t uRamp = 0;
    std::size_t uBow = 0;
    std::size_t vFlat = 0;
    std::size_t vRamp = 0;
    std::size_t vBow = 0;
};

[[nodiscard]] RampPlan planRamps(Questionnaire& questionnaire, const Ball& ball,
                                 const RampShape& shape, std::vector<Vector3> directions);

/// Ramps and bows of another steepness, with the same sides at the same points. They share the flat
/// maps of `first`.
[[nodiscard]] RampPlan planMoreRamps(Questionnaire& questionnaire, const Ball& ball,
                                     const RampPlan& first, double rise);

/// Tilts at one point, less the tilt on the flat map of that size; NaN if an answer is missing.
struct RampTilts {
    Vector3 direction;
    Vector3 onURamp;
    Vector3 onUBow;
    Vector3 onVRamp;
    Vector3 onVBow;
};

[[nodiscard]] std::vector<RampTilts> readRamps(const RampPlan& plan, const Answers& answers);

/// Map coordinates of each point. A bow's slope is that of the ramp times 1 - 2 x, so the ratio of
/// the two tilts gives x, whatever the tilts' sign, direction and strength.
[[nodiscard]] std::vector<Sighting> sightings(const std::vector<RampTilts>& tilts);

/// Quantile of the tilt's length on each ramp.
struct RampStrength {
    double alongU = 0.0;
    double alongV = 0.0;
};
[[nodiscard]] RampStrength strength(const std::vector<RampTilts>& tilts, double share = 0.5);

}  // namespace ticker::tasks::bump

#endif
