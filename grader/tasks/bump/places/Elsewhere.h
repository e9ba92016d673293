#ifndef TICKER_TASKS_BUMP_PLACES_ELSEWHERE_H
#define TICKER_TASKS_BUMP_PLACES_ELSEWHERE_H

#include <grader/tasks/bump/questions/Tilt.h>

#include <cstddef>

namespace ticker::tasks::bump {

/// One rough map on two spheres of the same radius, asked at the same directions from their
/// centres. On the first sphere these points are near the rim that the eye sees. The second one is
/// the first mirrored through the eye, so that there they all face away from it.
struct ElsewherePlan {
    std::size_t here = 0;
    std::size_t there = 0;
};

/// @param here  A question about points near the rim of its sphere.
[[nodiscard]] ElsewherePlan planElsewhere(Questionnaire& questionnaire, std::size_t here);

/// Share of the points whose normal differs between the two spheres. Right code gives equal
/// normals, except where rounding moves a point into the next texel. In single precision u and v
/// are off by about 1e-6 on a map of 320 texels, so that this happens to one point in 1500, and
/// never to 31 of 300. Code that turns or weakens normals which face away from the eye differs at
/// 0.25 of the points or more.
struct Elsewhere {
    double changed = 0.0;

    [[nodiscard]] bool good() const { return changed <= 0.1; }
};

[[nodiscard]] Elsewhere readElsewhere(const ElsewherePlan& plan, const Answers& answers);

}  // namespace ticker::tasks::bump

#endif
