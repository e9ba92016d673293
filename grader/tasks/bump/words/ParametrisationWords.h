#ifndef TICKER_TASKS_BUMP_PARAMETRISATIONWORDS_H
#define TICKER_TASKS_BUMP_PARAMETRISATIONWORDS_H

#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/Phrases.h>

#include <optional>

namespace ticker::tasks::bump {

/// What bump.wrong says where the map does not lie on the sphere as it should. Where a submission
/// does better tells why.
[[nodiscard]] Words landingWords(const Examination& examination, const std::optional<Hints>& hints);

/// What bump.wrong says where all is well on square maps of one size.
[[nodiscard]] Words sizeWords();

}  // namespace ticker::tasks::bump

#endif
