#ifndef TICKER_TASKS_DISTRIBUTED_HIGHLIGHTCHECK_H
#define TICKER_TASKS_DISTRIBUTED_HIGHLIGHTCHECK_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Says so where the ambient and the diffuse light are right and the highlight is not. The two are
/// told apart by their colours: the surface's own is in the diffuse light alone.
/// @param logs  Of one light each, whose colours fit nothing that is known.
[[nodiscard]] std::optional<Finding> highlightAlone(const std::vector<const ShadowLog*>& logs);

}  // namespace ticker::tasks

#endif
