#ifndef TICKER_REPAIR_SAMEANSWERS_H
#define TICKER_REPAIR_SAMEANSWERS_H

#include <grader/probe/Examinee.h>

namespace ticker::repair {

/// Whether an edit changes no bit of what was answered to the same questions, and nothing of what
/// was logged meanwhile.
[[nodiscard]] bool sameAnswers(const probe::Run& a, const probe::Run& b);

}  // namespace ticker::repair

#endif
