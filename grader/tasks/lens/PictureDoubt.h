#ifndef TICKER_TASKS_DISTRIBUTED_PICTUREDOUBT_H
#define TICKER_TASKS_DISTRIBUTED_PICTUREDOUBT_H

#include <grader/exercise/Task.h>

#include <optional>
#include <vector>

namespace ticker::tasks {

/// Right pictures have 0.04 (points in strata) to 1.05, hard shadows 1.5, everything sharp 3.2: see
/// the campaign *pictures* in docs/calibration.md.
inline constexpr double kMostMisfit = 1.1;

/// Questions are small and can be told from a picture; code that knows them may answer rightly and
/// render something else. Leaves such a submission to a person: where both tasks of option 2 have
/// passed, its picture of the handout's scene has to be near what its answers say.
/// @param tasks           T2.1 and T2.2; a doubt is a warning of the second.
/// @param misfits         Of the picture beside each aperture that was tried; none: no picture
/// came.
/// @param apertureFactor  What the answers show of the aperture; empty: nothing.
void doubtPicture(std::vector<TaskReport>& tasks, const std::vector<Misfit>& misfits,
                  const std::optional<double>& apertureFactor);

}  // namespace ticker::tasks

#endif
