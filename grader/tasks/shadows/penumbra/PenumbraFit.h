#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAFIT_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAFIT_H

#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>

#include <algorithm>
#include <vector>

namespace ticker::tasks {

/// How well the means in the penumbra fit the accepted readings.
struct PenumbraFit {
    double excessOfOthers = 1e9;     ///< least worstExcess of all readings but those below
    double excessOfNearSide = 1e9;   ///< least one of readings with the near side's falloff
    std::vector<double> openInBall;  ///< share of visible aims at each place, for a filled ball

    [[nodiscard]] double excess() const { return std::min(excessOfOthers, excessOfNearSide); }
    /// Whether the falloff of the near side fits clearly better than any other reading. Bernstein's
    /// bound alone does not tell, because it is wide: of 3000 right stages none exceeded 0.4 of it
    /// under its own reading, and most stages with the near side's falloff stay below 1 under
    /// another reading.
    [[nodiscard]] bool isNearSideAlone() const {
        return excessOfOthers > kSurely && excessOfNearSide < 0.75 * excessOfOthers &&
               excessOfNearSide <= 1.0;
    }
    /// A reading that fits so well leaves no doubt.
    static constexpr double kSurely = 0.5;
};

/// Tries every accepted shape of the light, densities between two of them, and every Phong reading.
/// @param sizeIsInDoubt  True if the light from the rim suggests a wrong size. Shapes whose means
///                       equal those of a ball of another size are then left out.
[[nodiscard]] PenumbraFit fitAcceptedShapes(PenumbraExpectations& expectations,
                                            const std::vector<PenumbraSamples>& seen,
                                            bool sizeIsInDoubt);

}  // namespace ticker::tasks

#endif
