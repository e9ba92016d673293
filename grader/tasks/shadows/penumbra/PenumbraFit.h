#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAFIT_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAFIT_H

#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>

#include <algorithm>
#include <vector>

namespace ticker::tasks {

/// How well the means in the penumbra fit the accepted readings.
struct PenumbraFit {
    double excessOfOthers = 1e9;     ///< worstExcess of the best reading but those below
    double excessOfNearSide = 1e9;   ///< of the best with the falloff of the light's near side
    std::vector<double> openInBall;  ///< share of visible aims at each place, for a filled ball

    [[nodiscard]] double excess() const { return std::min(excessOfOthers, excessOfNearSide); }
    /// Whether the falloff of the near side fits, and no other reading does. Bernstein's bound is
    /// wide: of 3000 right stages none was beyond 0.4 of it under its own reading, and most of the
    /// near side are below 1 under some other.
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
