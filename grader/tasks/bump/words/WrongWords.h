#ifndef TICKER_TASKS_BUMP_WRONGWORDS_H
#define TICKER_TASKS_BUMP_WRONGWORDS_H

#include <grader/tasks/bump/words/Diagnosis.h>
#include <grader/tasks/bump/words/Phrases.h>

#include <optional>

namespace ticker::tasks::bump {

/// Words of bump.wrong for each reason.
[[nodiscard]] Words wrongWords(WrongReason reason, const Examination& examination,
                               const std::optional<Hints>& hints);

}  // namespace ticker::tasks::bump

#endif
