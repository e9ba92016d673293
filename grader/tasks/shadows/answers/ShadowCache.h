#ifndef TICKER_TASKS_SHADOWS_ANSWERS_SHADOWCACHE_H
#define TICKER_TASKS_SHADOWS_ANSWERS_SHADOWCACHE_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Adds blocked rays (`isAdded`) where fewer rays were logged than the settings ask for. A shadow
/// cache (E. Haines, D. Greenberg, "The Light Buffer", IEEE CG&A 6(9), 1986) first intersects the
/// object that blocked an earlier ray, by itself; the log has no ray that meets this object.
[[nodiscard]] ShadowLog withCachedRays(ShadowLog log);

/// The same for all logs, if a shadow cache explains every ray that is missing: an earlier ray of
/// the same question was blocked; no ray follows a blocked one of its light and meets the object of
/// that ray and of the first blocked one, as it would in code that ends its loop early; and several
/// points have a ray that arrives after a blocked one. Empty otherwise, or if no ray is missing.
[[nodiscard]] std::optional<std::vector<ShadowLog>> withCachedRays(
    const std::vector<ShadowLog>& logs);

}  // namespace ticker::tasks

#endif
