#ifndef TICKER_TASKS_DISTRIBUTED_JUDGEDEPTHOFFIELD_H
#define TICKER_TASKS_DISTRIBUTED_JUDGEDEPTHOFFIELD_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/LensLog.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// What the answers about `render` say.
struct LensOutcome {
    std::vector<Finding> findings;         ///< of T2.2, unsorted
    std::optional<double> apertureFactor;  ///< half-width / dofAmount of the accepted reading
    std::vector<ScatterPlot> plots;        ///< where rays start and meet, where no finding shows it
    bool rayless = false;    ///< casts no ray that could be seen: only pictures can be judged
    bool valueless = false;  ///< its rays could be seen, but not what colour each of them gave
    bool cut = false;        ///< casts more rays than could be followed
};

/// Judges T2.2 from answered questions alone.
/// @param handout  At the handout's settings.
/// @param other    At other settings: what is wrong there alone is a warning.
[[nodiscard]] LensOutcome judgeDepthOfField(const LensLog& handout, const LensLog& other);

/// Judges `render` with several threads, where all was right with one.
[[nodiscard]] std::optional<Finding> judgeWithThreads(const LensLog& log);

/// Judges `render` after another one in the same program, where all was right in the first.
[[nodiscard]] std::optional<Finding> judgeNextRender(const LensLog& log);

}  // namespace ticker::tasks

#endif
