#ifndef TICKER_TASKS_BUMP_SIGNWORDS_H
#define TICKER_TASKS_BUMP_SIGNWORDS_H

#include <grader/tasks/bump/words/Phrases.h>

namespace ticker::tasks::bump {

/// Words for an inversion of both axes, or of one.
[[nodiscard]] Words invertedWords();
[[nodiscard]] Words invertedUWords();
[[nodiscard]] Words invertedVWords();

/// Words for a map whose top row lies at the bottom of the sphere.
[[nodiscard]] Words upsideDownWords();

/// Words for a wrong sign on a map that is upside down, too: once the map is turned round, the sign
/// may be right.
[[nodiscard]] Words signOnItsHeadWords(Words sign);

}  // namespace ticker::tasks::bump

#endif
