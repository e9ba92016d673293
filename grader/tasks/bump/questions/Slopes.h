#ifndef TICKER_TASKS_BUMP_SLOPES_H
#define TICKER_TASKS_BUMP_SLOPES_H

#include <grader/tasks/bump/answers/Parametrisation.h>
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/questions/Draws.h>
#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::bump {

/// Slopes as in pictures: sawtooth ramps of whole bytes along u and along v, and a smooth random
/// field of bytes, also on a very small sphere.
struct SlopePlan {
    std::vector<Vector3> directions;
    std::vector<Vector3> fieldDirections;
    LevelPair sawtoothU;
    LevelPair sawtoothV;
    LevelPair field;  ///< at `fieldDirections`
    std::vector<Vector3> smallDirections;
    LevelPair smallField;
};

[[nodiscard]] SlopePlan planSlopes(Questionnaire& questionnaire, Draws& draws, const Ball& ball);

/// Agreement of the tilts with those on the ramps, each axis with its sign there.
struct SlopeAgreement {
    double sawtoothU = 0.0;  ///< share of the points whose tilt has the same sign
    double sawtoothV = 0.0;
    double fieldU = 0.0;  ///< share of the tilt along u that has the slope's sign, weighted by
                          ///< both, less the share with the opposite sign
    double fieldV = 0.0;
    double smallU = 0.0;  ///< likewise, on the small sphere
    double smallV = 0.0;

    /// Sawtooth: at most a third of the points lie at the teeth's edges, wide differences included.
    /// Field: an interpolated or widely differenced slope keeps 0.97.
    [[nodiscard]] bool good() const {
        return sawtoothU >= 0.6 && sawtoothV >= 0.6 && fieldAgrees();
    }
    [[nodiscard]] bool fieldAgrees() const { return fieldU >= 0.9 && fieldV >= 0.9; }
    /// False for neighbours at a fixed distance in the world: on the small sphere 0.01 is 0.06 of
    /// the map's height.
    [[nodiscard]] bool smallAgrees() const { return smallU >= 0.9 && smallV >= 0.9; }
};

[[nodiscard]] SlopeAgreement readSlopes(const SlopePlan& plan, const Answers& answers,
                                        const Parametrisation& parametrisation,
                                        const Response& response);

/// Slope of a byte map along u at a point, in heights per texel, over two texels.
[[nodiscard]] double slopeAlongU(const probe::HeightMapDescription& map, double u, double v);
/// Likewise along v.
[[nodiscard]] double slopeAlongV(const probe::HeightMapDescription& map, double u, double v);

}  // namespace ticker::tasks::bump

#endif
