#ifndef TICKER_TASKS_DISTRIBUTED_UNEXPLAINEDSHADOWS_H
#define TICKER_TASKS_DISTRIBUTED_UNEXPLAINEDSHADOWS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <vector>

namespace ticker::tasks {

/// Whether points in full light are dark where rays hit something at once: the surface that they
/// leave. Whoever sorts such hits out himself gets the right colours nevertheless.
[[nodiscard]] bool shadowsItself(const std::vector<const ShadowLog*>& logs, bool viewerIsEye);

/// Whether points in full shadow are lit there: a ray that hits the surface it leaves was stopped
/// by that, and whoever takes it for free does not know what else stands in its way.
[[nodiscard]] bool leaksAtTheStart(const std::vector<const ShadowLog*>& logs, bool viewerIsEye);
[[nodiscard]] Finding leakAtTheStart();

/// Adds as evidence the first point whose value does not fit, for people to look at.
void addWorstPoint(const std::vector<const ShadowLog*>& logs, Finding& finding);

/// What is said where nothing that is known fits the colours.
[[nodiscard]] Finding unexplainedShadows(const std::vector<const ShadowLog*>& logs);
/// Likewise; says by an example what becomes of the share of rays, where there is one light that is
/// scaled by one number.
[[nodiscard]] Finding unexplainedWithOneLight(const std::vector<const ShadowLog*>& logs);

}  // namespace ticker::tasks

#endif
