#ifndef TICKER_TASKS_BUMP_LETTERMAP_H
#define TICKER_TASKS_BUMP_LETTERMAP_H

#include <grader/probe/Question.h>

namespace ticker::tasks::bump {

/// The map of letters: two rows of eight round the sphere, alternately H and L, from 45 degrees
/// above the equator to 45 below it.
inline constexpr int kLetterMapWidth = 640;
inline constexpr int kLetterMapHeight = 320;
/// Bytes by which an H stands above the ground and an L lies below it.
inline constexpr double kLetterLift = 80.0;

enum class Letter { none, h, l };

/// The letter in whose cell a texel lies.
[[nodiscard]] Letter letterAt(int column, int row);

/// Height of one texel above the ground, in units of kLetterLift: 1 on an H, -1 on an L. Edges are
/// even slopes of six texels (13 bytes for each texel).
[[nodiscard]] double letterHeight(int column, int row);

[[nodiscard]] probe::HeightMapDescription letterMap();

}  // namespace ticker::tasks::bump

#endif
