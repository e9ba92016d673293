#ifndef TICKER_TASKS_SHADOWS_MIXED_MIXEDCHECK_H
#define TICKER_TASKS_SHADOWS_MIXED_MIXEDCHECK_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Whether the colours of mixed scenes follow from their rays and from geometry, for code whose
/// answers to all other questions are right. The message says what the wrong points share.
/// @param reading   The one that fits all other questions.
/// @param raysSeen  Otherwise only what follows from geometry is compared.
[[nodiscard]] std::optional<Finding> checkMixed(const std::vector<const ShadowLog*>& logs,
                                                const ShadowReading& reading, bool raysSeen);

}  // namespace ticker::tasks

#endif
