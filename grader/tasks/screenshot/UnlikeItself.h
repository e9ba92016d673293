#ifndef TICKER_TASKS_SCREENSHOT_UNLIKEITSELF_H
#define TICKER_TASKS_SCREENSHOT_UNLIKEITSELF_H

#include <grader/result/SubmissionResult.h>

#include <string>
#include <vector>

namespace ticker::tasks {

/// Why two pictures of a random scene by the same code differ by more than noise, in words for a
/// person. Empty if no finding of these tasks is a reason.
[[nodiscard]] std::string whyUnlikeItself(const std::vector<TaskReport>& tasks);

}  // namespace ticker::tasks

#endif
