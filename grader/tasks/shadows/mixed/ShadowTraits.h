#ifndef TICKER_TASKS_SHADOWS_MIXED_SHADOWTRAITS_H
#define TICKER_TASKS_SHADOWS_MIXED_SHADOWTRAITS_H

#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <span>
#include <string_view>
#include <vector>

namespace ticker::tasks {

/// A point of a log.
struct PointOfLog {
    const ShadowLog* log = nullptr;
    const PointLog* point = nullptr;
};

/// What may be special about a point, its surface, its lights, or what stands around it.
struct PointTrait {
    std::string_view words;  ///< "there is ..." or "the ... is ..."
    bool (*has)(const PointOfLog& at);
    std::string_view hint;  ///< empty: nothing more to say
};

[[nodiscard]] std::span<const PointTrait> pointTraits();

/// The fewest traits that all wrong points share and that tell them from most right ones, the most
/// telling first; empty if nothing does. At most two.
[[nodiscard]] std::vector<const PointTrait*> tellingTraits(const std::vector<PointOfLog>& wrong,
                                                           const std::vector<PointOfLog>& right);

}  // namespace ticker::tasks

#endif
