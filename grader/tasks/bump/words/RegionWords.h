#ifndef TICKER_TASKS_BUMP_REGIONWORDS_H
#define TICKER_TASKS_BUMP_REGIONWORDS_H

#include <grader/tasks/bump/questions/Regions.h>
#include <grader/tasks/bump/questions/Stripes.h>
#include <grader/tasks/bump/words/Phrases.h>

namespace ticker::tasks::bump {

/// Words of bump.wrong where a large map tilts otherwise than narrow ramps: in which rows and
/// columns, and what to look for.
[[nodiscard]] Words regionWords(const RegionAgreement& regions);

/// The tilt across stripes of one grey changes along them.
[[nodiscard]] Words mixedWords(const StripeAgreement& stripes);

}  // namespace ticker::tasks::bump

#endif
