#ifndef TICKER_TASKS_BUMP_SIGNWORDS_H
#define TICKER_TASKS_BUMP_SIGNWORDS_H

#include <grader/tasks/bump/words/Phrases.h>

namespace ticker::tasks::bump {

/// What is said where both axes are inverted, or one alone.
[[nodiscard]] Words invertedWords();
[[nodiscard]] Words invertedUWords();
[[nodiscard]] Words invertedVWords();

/// What is said where the map's top row lies at the bottom.
[[nodiscard]] Words upsideDownWords();

/// What is said of a sign while the map stands on its head, too: turned round, it may be right.
[[nodiscard]] Words signOnItsHeadWords(Words sign);

}  // namespace ticker::tasks::bump

#endif
