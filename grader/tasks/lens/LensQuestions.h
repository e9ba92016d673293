#ifndef TICKER_TASKS_DISTRIBUTED_LENSQUESTIONS_H
#define TICKER_TASKS_DISTRIBUTED_LENSQUESTIONS_H

#include <grader/probe/Question.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Questions about `render` of T2.2. Their scenes have no light but the ambient one, so that
/// nothing that `illuminate` does wrong can be held against `render`.
struct LensQuestions {
    probe::RenderQuestion handout;  ///< the handout's settings, on a tiny frame, two repetitions
    probe::RenderQuestion other;    ///< other ray count, focal plane, aperture and bounces
};

[[nodiscard]] LensQuestions drawLensQuestions(std::uint64_t seed);

/// The handout's settings once more, with two threads, as the student's program has on any machine
/// of two cores.
[[nodiscard]] probe::RenderQuestion drawThreadsQuestion(std::uint64_t seed);

/// The handout's settings once more, and before that a picture as large of another part of a frame:
/// what is kept from the one is wrong in the other.
struct NextRender {
    probe::RenderQuestion before;
    probe::RenderQuestion next;
};
[[nodiscard]] NextRender drawNextRender(std::uint64_t seed);

/// Two rows of a picture as wide as the handout's: whether rays stay inside of pixels so small.
[[nodiscard]] probe::RenderQuestion drawFineQuestion(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
