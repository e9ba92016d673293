#ifndef TICKER_TASKS_LENS_QUESTIONS_LENSQUESTIONS_H
#define TICKER_TASKS_LENS_QUESTIONS_LENSQUESTIONS_H

#include <grader/probe/Question.h>

#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Questions about `render` of T2.2. Their scenes have ambient light only, so that mistakes in
/// `illuminate` do not count against `render`.
struct LensQuestions {
    probe::RenderQuestion handout;  ///< the handout's settings, on a tiny frame, two repetitions
    probe::RenderQuestion other;    ///< other ray count, focal plane, aperture and bounces
    probe::RenderQuestion odd;      ///< an odd number of rays, below the handout's
    probe::RenderQuestion many;     ///< more rays than fit into a byte
    std::vector<probe::RenderQuestion> mixed;  ///< see drawMixedRenders
};

[[nodiscard]] LensQuestions drawLensQuestions(std::uint64_t seed);

/// The handout's settings, with two threads, as the student's program uses on every machine with
/// two cores.
[[nodiscard]] probe::RenderQuestion drawThreadsQuestion(std::uint64_t seed);

/// The handout's settings, after a picture of the same size of another part of a frame: data kept
/// from the first picture is wrong in the second.
struct NextRender {
    probe::RenderQuestion before;
    probe::RenderQuestion next;
};
[[nodiscard]] NextRender drawNextRender(std::uint64_t seed);

/// Two rows of a picture as wide as the handout's: tells whether rays stay inside pixels of that
/// size.
[[nodiscard]] probe::RenderQuestion drawFineQuestion(std::uint64_t seed);

/// The handout's settings on a frame that is smaller still, once.
[[nodiscard]] probe::RenderQuestion drawScreenQuestion(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
