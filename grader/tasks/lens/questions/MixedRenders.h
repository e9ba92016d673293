#ifndef TICKER_TASKS_LENS_QUESTIONS_MIXEDRENDERS_H
#define TICKER_TASKS_LENS_QUESTIONS_MIXEDRENDERS_H

#include <grader/probe/Question.h>
#include <grader/tasks/support/Draw.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ticker::tasks {

/// Tiny renders with the handout's number of rays. Every other attribute is drawn independently,
/// from usual and extreme values: size of the picture, focal plane, lens, bounces, and what the
/// scene shows. If `render` has a condition on one of them that it should not have, some render is
/// wrong. The first has a focal plane nearer than 1, the second one farther than 20; in the last
/// one it goes through what a pixel shows.
[[nodiscard]] std::vector<probe::RenderQuestion> drawMixedRenders(std::uint64_t seed);

/// Size, scene and settings: "in a picture of 1 x 4 pixels of an empty scene, with ...".
[[nodiscard]] std::string wordsOf(const probe::RenderQuestion& asked);

/// Balls of many colours at all depths, so that neighbouring rays see different things, above a
/// floor. Colours lie above and below 1, so that clamping shows.
[[nodiscard]] raytracer::SceneDescription drawBalls(Draw& draw);

/// A render of this scene. Its log holds several times the events of a usual one.
[[nodiscard]] probe::RenderQuestion renderOf(Draw& draw, raytracer::SceneDescription scene,
                                             const raytracer::RenderSettings& settings,
                                             int repetitions = 1);

}  // namespace ticker::tasks

#endif
