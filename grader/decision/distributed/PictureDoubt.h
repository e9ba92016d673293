#ifndef TICKER_DECISION_DISTRIBUTED_PICTUREDOUBT_H
#define TICKER_DECISION_DISTRIBUTED_PICTUREDOUBT_H

#include <grader/result/SubmissionResult.h>

#include <optional>
#include <vector>

namespace ticker::decision {

/// Questions are small and can be told from a picture; code that knows them may answer rightly and
/// render something else. Leaves such a submission to a person: where both tasks of option 2 have
/// passed, its picture of the handout's scene has to be near what they ask for.
/// @param tasks   T2.1 and T2.2; a doubt is a warning of the second.
/// @param misfit  Of the picture of the handout's scene: mean square of a pixel's
///                difference from what is right, in standard errors; empty: none came.
void doubtPicture(std::vector<TaskReport>& tasks, const std::optional<double>& misfit);

}  // namespace ticker::decision

#endif
