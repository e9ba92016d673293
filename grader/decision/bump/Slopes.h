#ifndef TICKER_DECISION_BUMP_SLOPES_H
#define TICKER_DECISION_BUMP_SLOPES_H

#include <grader/decision/bump/Draws.h>
#include <grader/decision/bump/Landing.h>
#include <grader/decision/bump/Response.h>
#include <grader/decision/bump/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::decision::bump {

/// A map, and the flat one of its size at the same points.
struct LevelPair {
    std::size_t flat = 0;
    std::size_t map = 0;
};

/// Slopes as pictures have them: sawtooth ramps of whole bytes along u and along v, a ramp along
/// both, and a smooth random field of bytes.
struct SlopePlan {
    std::vector<Vector3> directions;
    std::vector<Vector3> fieldDirections;
    LevelPair sawtoothU;
    LevelPair sawtoothV;
    LevelPair oblique;
    LevelPair field;  ///< at `fieldDirections`
};

[[nodiscard]] SlopePlan planSlopes(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

struct SlopeAgreement {
    double sawtoothU = 0.0;  ///< share of the points whose tilt leans the right way
    double sawtoothV = 0.0;
    double oblique = 0.0;  ///< share that leans the right way along both axes
    double fieldU = 0.0;   ///< of the tilt along u: the share that leans against the slope along u,
                           ///< weighted by both, less the share that leans into it
    double fieldV = 0.0;

    /// Sawtooth: the teeth's edges and what a wide difference smears of them are a third at most.
    /// Oblique: only the seam strays. Field: an interpolated or widely differenced slope keeps
    /// 0.97.
    [[nodiscard]] bool good() const {
        return sawtoothU >= 0.6 && sawtoothV >= 0.6 && oblique >= 0.95 && fieldU >= 0.9 &&
               fieldV >= 0.9;
    }
};

[[nodiscard]] SlopeAgreement readSlopes(const SlopePlan& plan, const Answers& answers,
                                        const Landing& landing, const Response& response);

/// The slope of a byte map along u at a point, heights per texel, over two texels.
[[nodiscard]] double slopeAlongU(const probe::HeightMapDescription& map, double u, double v);
/// Likewise along v.
[[nodiscard]] double slopeAlongV(const probe::HeightMapDescription& map, double u, double v);

}  // namespace ticker::decision::bump

#endif
