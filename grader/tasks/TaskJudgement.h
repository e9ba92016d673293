#ifndef TICKER_TASKS_TASKJUDGEMENT_H
#define TICKER_TASKS_TASKJUDGEMENT_H

#include <grader/result/SubmissionResult.h>

namespace ticker::tasks {

using ticker::TaskJudgement;

}  // namespace ticker::tasks

#endif
