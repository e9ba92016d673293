#include <grader/tasks/shadows/penumbra/PenumbraFit.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

/// Expected shares of one shape at each place.
using Expected = std::vector<ExpectedShares>;

// The means of these shapes equal those of a ball a tenth smaller or larger: only light from the
// rim and beyond distinguishes them.
bool isLikeAnotherSize(AimShape shape) {
    using Radius = AimShape::Radius;
    if (shape.radius == Radius::root || shape.radius == Radius::flat) return true;
    return shape.poles != AimShape::Poles::none && shape.radius != Radius::uniform;
}

// From densest in the middle to densest at the rim.
constexpr std::array kByDensity{AimShape::uniformRadius, AimShape::rootRadius, AimShape::ball,
                                AimShape::flatDisc, AimShape::surface};

/// Tries all Phong readings for a density between two: means are linear in the density.
void tryDensity(const std::vector<PenumbraSamples>& seen, const Expected& first,
                const Expected& second, double part, PenumbraFit& fit) {
    const auto mixed = [&](auto valueOf) {
        std::vector<double> values;
        for (std::size_t i = 0; i < first.size(); ++i)
            values.push_back(valueOf(first[i]) * (1.0 - part) + valueOf(second[i]) * part);
        return values;
    };
    const std::vector<double> open = mixed([](const ExpectedShares& at) { return at.open; });
    for (const std::size_t eye : {0U, 1U})
        for (std::size_t phong = 0; phong < ExpectedShares::kPhongReadings; ++phong) {
            const auto shares =
                mixed([=](const ExpectedShares& at) { return at.share[eye][phong]; });
            double& best =
                ExpectedShares::isNearSide(phong) ? fit.excessOfNearSide : fit.excessOfOthers;
            best = std::min(best, worstExcess(seen, shares, open));
        }
}

// Whether no further shapes need be tried. If the near side's falloff fits best so far, they are
// tried: its warning says that no other reading fits.
bool isDecided(const PenumbraFit& fit) {
    const bool mayBeNearSide =
        fit.excessOfNearSide < fit.excessOfOthers && fit.excessOfOthers > PenumbraFit::kSurely;
    return fit.excess() <= 1.0 && !mayBeNearSide;
}

}  // namespace

PenumbraFit fitAcceptedShapes(PenumbraExpectations& expectations,
                              const std::vector<PenumbraSamples>& seen, bool sizeIsInDoubt) {
    const auto expectedOf = [&](AimShape shape) {
        Expected expected;
        for (const PenumbraSamples& samples : seen)
            expected.push_back(expectations.at(samples.place, shape));
        return expected;
    };
    PenumbraFit fit;
    for (const AimShape shape : kAcceptedAimShapes) {
        if (isLikeAnotherSize(shape) && (sizeIsInDoubt || isDecided(fit))) continue;
        const Expected expected = expectedOf(shape);
        tryDensity(seen, expected, expected, 0.0, fit);
        if (shape == AimShape::ball)
            for (const ExpectedShares& at : expected)
                fit.openInBall.push_back(at.open);
    }
    if (sizeIsInDoubt || isDecided(fit)) return fit;
    Expected last;
    for (const AimShape shape : kByDensity) {
        Expected next = expectedOf(shape);
        if (!last.empty())
            for (const double part : {0.25, 0.5, 0.75})
                tryDensity(seen, last, next, part, fit);
        last = std::move(next);
    }
    return fit;
}

}  // namespace ticker::tasks
