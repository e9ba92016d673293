#ifndef TICKER_EXERCISE_JUDGE_H
#define TICKER_EXERCISE_JUDGE_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <functional>

namespace ticker {

/// Judges a submission as `Task::judge` does. Several threads may call it.
using Judge = std::function<TaskJudgement(probe::Examinee& examinee, std::uint64_t seed)>;

}  // namespace ticker

#endif
