#ifndef TICKER_TASKS_SHADOWS_CHECKS_HIGHLIGHTCHECK_H
#define TICKER_TASKS_SHADOWS_CHECKS_HIGHLIGHTCHECK_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// A finding if the ambient and the diffuse light are right and the highlight is not. Colours
/// separate the two: only the diffuse light has the surface's own colour.
/// @param logs  Questions with one light each, whose colours fit no known mistake.
[[nodiscard]] std::optional<Finding> highlightAlone(const std::vector<const ShadowLog*>& logs);

/// The same for points where R.V is below 0 and no highlight is expected.
[[nodiscard]] std::optional<Finding> highlightOfLowLight(const std::vector<const ShadowLog*>& logs);

}  // namespace ticker::tasks

#endif
