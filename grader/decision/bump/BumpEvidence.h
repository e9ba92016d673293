#ifndef TICKER_DECISION_BUMP_BUMPEVIDENCE_H
#define TICKER_DECISION_BUMP_BUMPEVIDENCE_H

#include <grader/decision/bump/Diagnosis.h>
#include <grader/result/Finding.h>

#include <vector>

namespace ticker::decision::bump {

/// Everything that was measured, as result.json has it. docs/findings explains the keys.
[[nodiscard]] Evidence evidenceOf(const std::vector<Fault>& faults, const Examination& examination);

}  // namespace ticker::decision::bump

#endif
