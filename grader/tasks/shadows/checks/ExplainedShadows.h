#ifndef TICKER_TASKS_SHADOWS_CHECKS_EXPLAINEDSHADOWS_H
#define TICKER_TASKS_SHADOWS_CHECKS_EXPLAINEDSHADOWS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Words for colours that fit no named arithmetic, where one rule with a number explains all of
/// them: ambient light that is scaled, hits compared with another distance than the light's, and
/// light that each blocked ray multiplies.
/// @param logs  Questions with one light each, whose colours are wrong.
[[nodiscard]] std::optional<Finding> explainedShadows(const std::vector<const ShadowLog*>& logs);

}  // namespace ticker::tasks

#endif
