#ifndef TICKER_TASKS_SHADOWS_SHADOWSTAGES_H
#define TICKER_TASKS_SHADOWS_SHADOWSTAGES_H

#include <grader/tasks/shadows/checks/LitRender.h>
#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>
#include <grader/tasks/support/Stage.h>

namespace ticker::tasks {

// Each stage asks questions of its own, drawn from `seed` and the stage's number.

/// Judges the values of `illuminate` at the edges of shadows, for code whose rays are not visible.
[[nodiscard]] Stage judgePenumbra(probe::Examinee& examinee, PenumbraShelf& shelf,
                                  std::uint64_t seed, std::uint64_t stage);
/// Judges `illuminate` inside of `render`. With one thread a difference from single points needs
/// review; with two threads a difference from one thread fails. Two threads are asked again, up to
/// seven times, until they have interrupted each other at enough points.
/// @param visible  What single points showed: a render is expected to show as much.
[[nodiscard]] Stage judgeLitRender(probe::Examinee& examinee, std::uint64_t seed,
                                   std::uint64_t stage, const VisibleRays& visible);

}  // namespace ticker::tasks

#endif
