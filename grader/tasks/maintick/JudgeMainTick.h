#ifndef TICKER_TASKS_MAINTICK_JUDGEMAINTICK_H
#define TICKER_TASKS_MAINTICK_JUDGEMAINTICK_H

#include <grader/exercise/Judge.h>
#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>

namespace ticker::tasks {

/// M1: `Sphere::intersectionWith`.
[[nodiscard]] TaskJudgement judgeSpheres(probe::Examinee& examinee, std::uint64_t seed);
/// M2: `Renderer::illuminate` where nothing stands in the way of the light.
[[nodiscard]] TaskJudgement judgePhong(probe::Examinee& examinee, std::uint64_t seed);
/// M3.1: `Plane::intersectionWith`.
[[nodiscard]] TaskJudgement judgePlanes(probe::Examinee& examinee, std::uint64_t seed);
/// M3.2: `Renderer::illuminate` where an object hides the light. The colour is compared with what
/// the same code gives without that object, so that a mistake of M2 does not count twice.
[[nodiscard]] TaskJudgement judgeHardShadows(probe::Examinee& examinee, std::uint64_t seed);
/// M4: `Renderer::trace`, compared with what the same code's `illuminate` gives for each surface.
[[nodiscard]] TaskJudgement judgeReflections(probe::Examinee& examinee, std::uint64_t seed);

// The same for many submissions: the questions of a seed, which take longer to draw than to judge,
// are drawn once.

[[nodiscard]] Judge judgePhongOfMany();
[[nodiscard]] Judge judgeHardShadowsOfMany();
[[nodiscard]] Judge judgeReflectionsOfMany();

}  // namespace ticker::tasks

#endif
