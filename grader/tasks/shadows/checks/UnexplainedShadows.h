#ifndef TICKER_TASKS_SHADOWS_CHECKS_UNEXPLAINEDSHADOWS_H
#define TICKER_TASKS_SHADOWS_CHECKS_UNEXPLAINEDSHADOWS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <vector>

namespace ticker::tasks {

/// Whether points in full light are dark because rays hit the surface that they leave (shadow
/// acne). Code that discards such hits itself gets right colours.
[[nodiscard]] bool shadowsItself(const std::vector<const ShadowLog*>& logs, bool viewerIsEye);

/// Whether points in full shadow are lit because rays hit the surface that they leave. Code that
/// counts such a ray as free misses the objects behind the first hit.
[[nodiscard]] bool leaksAtTheStart(const std::vector<const ShadowLog*>& logs, bool viewerIsEye);
[[nodiscard]] Finding leakAtTheStart();

/// Adds the first point whose value does not fit as evidence.
void addWorstPoint(const std::vector<const ShadowLog*>& logs, Finding& finding);

/// The finding for colours that no known mistake explains.
[[nodiscard]] Finding unexplainedShadows(const std::vector<const ShadowLog*>& logs);
/// Like unexplainedShadows for questions with one light. If one number scales that light, an
/// example compares it with the share of rays.
[[nodiscard]] Finding unexplainedWithOneLight(const std::vector<const ShadowLog*>& logs);

}  // namespace ticker::tasks

#endif
