#ifndef TICKER_TASKS_BUMP_PLACES_ELSEWHERE_H
#define TICKER_TASKS_BUMP_PLACES_ELSEWHERE_H

#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>

namespace ticker::tasks::bump {

/// One rough map on two spheres of one radius, at the same directions from their centres: those
/// near the rim that the eye sees of the one. The other stands mirrored through the eye, so that
/// they all face away there.
struct ElsewherePlan {
    std::size_t here = 0;
    std::size_t there = 0;
};

/// @param here  A question about points near the rim of its sphere.
[[nodiscard]] ElsewherePlan planElsewhere(Questionnaire& questionnaire, std::size_t here);

/// Share of the points whose normal is another one on the other sphere. Right code gives the very
/// same normals but for rounding: a point can fall into the texel beside. In single precision u and
/// v are off by some 1e-6 of a map of 320 texels, so one point in 1500 does, and 31 of 300 never. A
/// normal that is turned or weakened where it faces away from the eye differs at 0.25 of the
/// points and more.
struct Elsewhere {
    double changed = 0.0;

    [[nodiscard]] bool good() const { return changed <= 0.1; }
};

[[nodiscard]] Elsewhere readElsewhere(const ElsewherePlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
