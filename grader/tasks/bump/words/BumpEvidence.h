#ifndef TICKER_TASKS_BUMP_BUMPEVIDENCE_H
#define TICKER_TASKS_BUMP_BUMPEVIDENCE_H

#include <grader/result/Finding.h>
#include <grader/tasks/bump/words/Diagnosis.h>

#include <vector>

namespace ticker::tasks::bump {

/// All measured values for result.json. docs/findings.md explains the keys.
[[nodiscard]] Evidence evidenceOf(const std::vector<Fault>& faults, const Examination& examination);

}  // namespace ticker::tasks::bump

#endif
