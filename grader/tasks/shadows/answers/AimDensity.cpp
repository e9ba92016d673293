#include <grader/tasks/shadows/answers/AimDensity.h>
#include <grader/tasks/support/Bounds.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ticker::tasks {
namespace {

/// Share of `sorted` up to `value`.
double shareWithin(const std::vector<double>& sorted, double value) {
    const auto end = std::upper_bound(sorted.begin(), sorted.end(), value);
    return static_cast<double>(end - sorted.begin()) / static_cast<double>(sorted.size());
}

bool staysBetween(const std::vector<double>& seen, const std::vector<const Feet*>& accepted,
                  std::size_t distinct) {
    const double slack = dkwBound(distinct) + kLatticeError;
    const double weight = 1.0 / static_cast<double>(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        double most = 0.0;
        double least = 1.0;
        for (const Feet* feet : accepted) {
            const double share = shareWithin(feet->lengths(), seen[i]);
            most = std::max(most, share);
            least = std::min(least, share);
        }
        const auto before = static_cast<double>(i);
        if ((before + 1.0) * weight > most + slack || before * weight < least - slack) return false;
    }
    return true;
}

// The distance from the centre, in radii of the light, beyond which at least one of `distinct`
// lines passes. Of the accepted shapes, uniform radius and direction has the fewest lines at the
// rim: a share of at least (1 - r^2)^1.5 / 3 passes outside of r.
double leastRim(std::size_t distinct) {
    constexpr double kRisk = 4e-7;
    const double share = std::min(1.0 / 3.0, missedShare(distinct, kRisk));
    return std::sqrt(1.0 - std::pow(3.0 * share, 2.0 / 3.0));
}

}  // namespace

bool liesBetween(const Views& seen, const std::vector<Vector3>& directions,
                 const AimVerdict& verdict) {
    if (verdict.widest < leastRim(verdict.distinct)) return false;
    std::vector<Views> accepted;
    for (const AimShape shape : kAcceptedAimShapes)
        accepted.push_back(expectedViews(shape, directions));
    const auto holds = [&](const Feet& feet, const auto& viewOf) {
        std::vector<const Feet*> same;
        for (const Views& views : accepted)
            same.push_back(&viewOf(views));
        return staysBetween(feet.lengths(), same, std::min(verdict.distinct, feet.count()));
    };
    for (std::size_t i = 0; i < seen.each.size(); ++i)
        if (!holds(seen.each[i], [i](const Views& views) -> const Feet& { return views.each[i]; }))
            return false;
    return holds(seen.all, [](const Views& views) -> const Feet& { return views.all; });
}

}  // namespace ticker::tasks
