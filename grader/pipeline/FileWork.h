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

/// How far one submitted file came: what is known about its tasks before anybody asks it.
struct FileWork {
    std::vector<TaskReport> tasks;          ///< of this file; `notAttempted` or `blocked` are final
    std::optional<build::Program> program;  ///< there, where a task is still to be judged
    std::optional<Diagnostics> diagnostics;
    double compileMs = 0.0;
};

/// A report of a task that is not judged yet.
[[nodiscard]] TaskReport blankReport(const std::string& task, const Exercise& exercise);

/// Takes over what a judge says.
void settle(TaskReport& task, TaskJudgement judgement);

/// Checks one file in, finds out which of its tasks were attempted, and builds it where one was.
[[nodiscard]] FileWork prepareFile(const intake::Submission& submission, const std::string& file,
                                   const Grader& grader);

/// What is said of a program that answered, but was ended at a forbidden system call in a run that
/// asked it for more, such as a picture.
[[nodiscard]] Finding forbiddenCallFinding();

/// True where the task is still to be judged.
[[nodiscard]] bool isOpen(const TaskReport& task);

}  // namespace ticker::pipeline

#endif
