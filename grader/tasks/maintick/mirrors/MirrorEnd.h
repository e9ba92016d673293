#ifndef TICKER_TASKS_MAINTICK_MIRRORS_MIRROREND_H
#define TICKER_TASKS_MAINTICK_MIRRORS_MIRROREND_H

#include <grader/probe/Examinee.h>
#include <grader/result/Finding.h>

#include <cstddef>
#include <optional>

namespace ticker::tasks::maintick {

/// Where the answers about mirrors that face each other stand in a run: those in the light, and
/// those with many bounces (`drawDeepMirrors`).
inline constexpr std::size_t kFacing = 1;
inline constexpr std::size_t kDeep = 3;

/// The finding for a program that crashed, or ran out of time or memory, between mirrors that face
/// each other: `mirror.endless` where it already did so with few bounces, else `mirror.bounces`.
/// Empty if these questions have answers.
[[nodiscard]] std::optional<Finding> checkMirrorEnd(const probe::Run& run);

/// Whether only the rays with many bounces took too long. Code that calls trace three times for
/// each reflection, once for each colour, is right and takes 3^18 calls for 18 bounces.
[[nodiscard]] bool isSlowWithManyBounces(const probe::Run& run);

}  // namespace ticker::tasks::maintick

#endif
