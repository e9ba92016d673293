#ifndef TICKER_TASKS_SHADOWS_MIXED_SHADOWTRAITS_H
#define TICKER_TASKS_SHADOWS_MIXED_SHADOWTRAITS_H

#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/tasks/support/Traits.h>

#include <span>

namespace ticker::tasks {

/// A point of a log.
struct PointOfLog {
    const ShadowLog* log = nullptr;
    const PointLog* point = nullptr;
};

/// What may be special about a point, its surface, its lights, or what stands around it, as a
/// clause: "there is no point light".
using PointTrait = Trait<PointOfLog>;
[[nodiscard]] std::span<const PointTrait> pointTraits();

}  // namespace ticker::tasks

#endif
