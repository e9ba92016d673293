#ifndef TICKER_TASKS_LENS_JUDGEDEPTHOFFIELD_H
#define TICKER_TASKS_LENS_JUDGEDEPTHOFFIELD_H

#include <grader/result/Finding.h>
#include <grader/tasks/lens/answers/LensLog.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Result of the answers about `render`.
struct LensOutcome {
    std::vector<Finding> findings;         ///< of T2.2, unsorted
    std::optional<double> apertureFactor;  ///< half-width / dofAmount of the accepted reading
    std::vector<ScatterPlot>
        plots;               ///< starts and meeting points of the rays, unless a finding shows them
    bool rayless = false;    ///< pixels have no visible ray: only pictures can be judged
    bool partly = false;     ///< `rayless`, but other pixels have visible rays
    bool onlyExtra = false;  ///< `rayless`, but for a pinhole ray of each pixel
    bool valueless = false;  ///< the rays are visible, but not the colour of each
    bool cut = false;        ///< casts more rays than could be followed
};

/// Whether one of the findings reports antialiasing: rays through different places of the pixel.
[[nodiscard]] bool isAntialiased(const std::vector<Finding>& findings);

/// Judges T2.2 from answered questions alone.
/// @param handout  Answers at the handout's settings.
/// @param other    Answers at other settings: a fault there alone is a warning.
[[nodiscard]] LensOutcome judgeDepthOfField(const LensLog& handout, const LensLog& other);

/// Judges an odd number of rays, of which pairs or other groups leave some over, for code that is
/// right at the handout's number. Fails on too few rays, or on a mean over another number of them.
[[nodiscard]] std::optional<Finding> judgeOddCount(const LensLog& odd);

/// Judges more than 255 rays, for code that casts more rays in `other` than in `handout`; empty for
/// other code.
[[nodiscard]] std::optional<Finding> judgeManyRays(const LensLog& many, const LensLog& handout,
                                                   const LensLog& other);

/// The first failure of a mixed render, for code that follows other settings.
[[nodiscard]] std::optional<Finding> judgeMixed(const LensLog& log);

/// The first failure of an answer, by itself. The hint says that another scene was rendered
/// rightly.
[[nodiscard]] std::optional<Finding> judgeAnotherScene(const LensLog& log);

/// Judges `render` with several threads, for code that is right with one.
[[nodiscard]] std::optional<Finding> judgeWithThreads(const LensLog& log);

/// Judges `render` after another render in the same program, for code that is right in the first.
[[nodiscard]] std::optional<Finding> judgeNextRender(const LensLog& log);

}  // namespace ticker::tasks

#endif
