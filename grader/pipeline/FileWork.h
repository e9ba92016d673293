#ifndef TICKER_PIPELINE_FILEWORK_H
#define TICKER_PIPELINE_FILEWORK_H

#include <grader/build/Build.h>
#include <grader/intake/Submission.h>
#include <grader/pipeline/Grade.h>
#include <grader/result/SubmissionResult.h>

#include <optional>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// State of one submitted file before the first question is asked.
struct FileWork {
    std::vector<TaskReport> tasks;  ///< tasks of this file; `notAttempted` and `blocked` are final
    std::optional<build::Program> program;  ///< present if a task is still to be judged
    std::optional<Diagnostics> diagnostics;
    double compileMs = 0.0;
};

/// A report of a task that is not judged yet.
[[nodiscard]] TaskReport blankReport(const std::string& task, const Exercise& exercise);

/// Copies a judgement into the report.
void settle(TaskReport& task, TaskJudgement judgement);

/// Checks one file, determines which of its tasks were attempted, and builds it if any was.
[[nodiscard]] FileWork prepareFile(const intake::Submission& submission, const std::string& file,
                                   const Grader& grader);

/// The finding for a program that answered, but was ended at a forbidden system call in a later
/// run, such as a picture.
[[nodiscard]] Finding forbiddenCallFinding();

/// True where the task is still to be judged.
[[nodiscard]] bool awaitsJudge(const TaskReport& task);

}  // namespace ticker::pipeline

#endif
