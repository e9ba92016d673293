#ifndef TICKER_TASKS_BUMP_PARAMETRISATIONWORDS_H
#define TICKER_TASKS_BUMP_PARAMETRISATIONWORDS_H

#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/Phrases.h>

#include <optional>

namespace ticker::tasks::bump {

/// Words of bump.wrong for a wrong parametrisation. The hints (cases in which the submission is
/// right) tell the cause.
[[nodiscard]] Words landingWords(const Examination& examination, const std::optional<Hints>& hints);

/// True for code that is right on a square map, but not on a sphere far to the side and below.
[[nodiscard]] bool isWrongAsideAlone(const std::optional<Hints>& hints);
/// Words of bump.wrong for such code.
[[nodiscard]] Words asideWords();

/// Words of bump.wrong for code that is right on square maps of one size.
[[nodiscard]] Words sizeWords();

}  // namespace ticker::tasks::bump

#endif
