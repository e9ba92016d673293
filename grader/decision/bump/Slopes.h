#ifndef TICKER_DECISION_BUMP_SLOPES_H
#define TICKER_DECISION_BUMP_SLOPES_H

#include <grader/decision/bump/Draws.h>
#include <grader/decision/bump/Landing.h>
#include <grader/decision/bump/Response.h>
#include <grader/decision/bump/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::decision::bump {

/// Slopes as pictures have them: sawtooth ramps of whole bytes along u and along v, a ramp along
/// both, and a smooth random field of bytes.
struct SlopePlan {
    std::vector<Vector3> directions;
    std::vector<Vector3> fieldDirections;
    std::size_t sawtoothU = 0;
    std::size_t sawtoothV = 0;
    std::size_t oblique = 0;
    std::size_t field = 0;
};

[[nodiscard]] SlopePlan planSlopes(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

struct SlopeAgreement {
    double sawtoothU = 0.0;  ///< share of the points whose tilt leans the right way
    double sawtoothV = 0.0;
    double oblique = 0.0;            ///< share that leans the right way along both axes
    double fieldCorrelationU = 0.0;  ///< of the tilt along u with the slope along u
    double fieldCorrelationV = 0.0;

    /// Sawtooth: the teeth's edges and what a wide difference smears of them are a fifth. Oblique:
    /// only the seam strays. Field: an interpolated or widely differenced slope keeps 0.95.
    [[nodiscard]] bool good() const {
        return sawtoothU >= 0.7 && sawtoothV >= 0.7 && oblique >= 0.95 &&
               fieldCorrelationU >= 0.8 && fieldCorrelationV >= 0.8;
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
