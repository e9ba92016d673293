#ifndef TICKER_PIPELINE_GRADE_H
#define TICKER_PIPELINE_GRADE_H

#include <grader/build/Kit.h>
#include <grader/exercise/Exercise.h>
#include <grader/exercise/Task.h>
#include <grader/intake/Submission.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/result/SubmissionResult.h>
#include <grader/rubric/Rubric.h>
#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>
#include <grader/tasks/Tasks.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// Data that all submissions of a batch share. Immutable, so that threads may share it.
struct Grader {
    build::Kit kit;
    sandbox::Sandbox sandbox;
    sandbox::SandboxPolicy policy;
    rubric::Rubric rubric;
    std::string toolVersion;
    /// Name of the option to judge; tasks of other files count as not attempted. Empty: all.
    std::string option = {};
    /// True if only one submission is graded: independent steps may then run in parallel.
    bool isAlone = false;
    std::vector<SpecScene> scenes = {};  ///< rendered for the report; may be empty
    std::string build = {};              ///< digest of the tool, see ResultInputs.h; may be empty
    std::string rubricText = {};         ///< text of the file that `rubric` was read from
    const Exercise* exercise = &defaultExercise();
    std::span<const Task> tasks = tasks::tasksOf(exercise->name);  ///< the code of its tasks
};

/// The code of a task.
/// @throws raytracer::Error if the exercise has no code for it.
[[nodiscard]] const Task& codeOf(const Grader& grader, const std::string& id);

/// Judges one submission: builds each attempted file, asks it, applies the rubric.
///
/// The result describes everything the submission does or fails to do. It always contains the
/// exercise's tasks and, after them, "screenshot" if the exercise has one.
///
/// @param seed  Source of the hidden questions, which are drawn after the submission was compiled.
/// @throws raytracer::Error if grading failed because of the grader or its system.
[[nodiscard]] SubmissionResult gradeSubmission(const intake::Submission& submission,
                                               const Grader& grader, std::uint64_t seed);

/// The result of a submission that could not be graded because of the grader or its system: every
/// task is notGraded.
[[nodiscard]] SubmissionResult notGradedResult(const std::string& name, const std::string& reason,
                                               const Grader& grader, std::uint64_t seed);

}  // namespace ticker::pipeline

#endif
