#ifndef TICKER_TASKS_DRAWINGS_DRAWBUMPS_H
#define TICKER_TASKS_DRAWINGS_DRAWBUMPS_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

namespace ticker::tasks {

/// Draws the normals along two letters of one row of the map of letters: the smooth one, the one
/// that is expected, and the one that the code gives. Only for a failed judgement of T1 whose first
/// finding has the parametrisation in its evidence; does nothing otherwise.
void drawBumps(probe::Examinee& examinee, TaskJudgement& judgement);

}  // namespace ticker::tasks

#endif
