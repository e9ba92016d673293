#ifndef TICKER_TASKS_SHADOWS_JUDGESOFTSHADOWS_H
#define TICKER_TASKS_SHADOWS_JUDGESOFTSHADOWS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Result of the answers about `illuminate`.
struct ShadowOutcome {
    std::vector<Finding> findings;         ///< of T2.1, unsorted
    std::optional<ShadowReading> reading;  ///< the accepted reading that fits everywhere
    std::vector<ScatterPlot> plots;        ///< the rays' aims, unless a finding shows them
    bool rayless = false;                  ///< the rays are not visible: only values can be judged
    bool onlyExtra = false;                ///< likewise, but for rays to the light's centre
    bool cached = false;  ///< a shadow cache hides some blocked rays: the others were judged
    bool cut = false;     ///< casts more rays than could be followed
};

/// Judges T2.1 from answered questions alone: no randomness, no asking.
/// @param logs  At least one of purpose oneLight and one of farLight, each with a point.
[[nodiscard]] ShadowOutcome judgeSoftShadows(const std::vector<ShadowLog>& logs);

}  // namespace ticker::tasks

#endif
