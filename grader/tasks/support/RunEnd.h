#ifndef TICKER_TASKS_SUPPORT_RUNEND_H
#define TICKER_TASKS_SUPPORT_RUNEND_H

#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <optional>
#include <string_view>

namespace ticker::tasks {

/// The words of a process that does not end properly.
struct BadEnd {
    std::string_view id;    ///< of the finding
    std::string_view seen;  ///< "it crashed"
    std::string_view hint;
};
/// @param kind  Not `ourFault`. `finished`: it finished, but answers are missing.
[[nodiscard]] BadEnd badEnd(probe::ProcessEnd::Kind kind);

/// The judgement of a task with missing answers, or whose program did not finish; empty if all
/// answers are present and it finished.
/// @param function  Name of the student's function that was asked, for messages: "illuminate".
[[nodiscard]] std::optional<TaskJudgement> judgeUnanswered(const probe::Run& run,
                                                           std::string_view function);

}  // namespace ticker::tasks

#endif
