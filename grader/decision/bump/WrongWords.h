#ifndef TICKER_DECISION_BUMP_WRONGWORDS_H
#define TICKER_DECISION_BUMP_WRONGWORDS_H

#include <grader/decision/bump/Diagnosis.h>
#include <grader/decision/bump/Phrases.h>

#include <optional>

namespace ticker::decision::bump {

/// What bump.wrong says, for each reason.
[[nodiscard]] Words wrongWords(WrongReason reason, const Examination& examination,
                               const std::optional<Hints>& hints);

}  // namespace ticker::decision::bump

#endif
