#ifndef TICKER_TASKS_BUMP_LETTERMAP_H
#define TICKER_TASKS_BUMP_LETTERMAP_H

#include <grader/probe/Question.h>

namespace ticker::tasks::bump {

/// The map of letters: two rows of eight round the sphere, H and L by turns, between 45 degrees
/// above the equator and 45 below it.
inline constexpr int kLetterMapWidth = 640;
inline constexpr int kLetterMapHeight = 320;
/// Bytes by which an H stands above the ground and an L lies below it.
inline constexpr double kLetterLift = 80.0;

enum class Letter { none, h, l };

/// Whose cell a texel lies in.
[[nodiscard]] Letter letterAt(int column, int row);

/// Height above the ground of one texel, in units of kLetterLift: 1 on an H, -1 on an L, with even
/// slopes of six texels (13 bytes for each texel) at the edges.
[[nodiscard]] double letterHeight(int column, int row);

[[nodiscard]] probe::HeightMapDescription letterMap();

}  // namespace ticker::tasks::bump

#endif
