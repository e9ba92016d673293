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

/// What all submissions of a batch share. Never changes, so threads may share it.
struct Grader {
    build::Kit kit;
    sandbox::Sandbox sandbox;
    sandbox::SandboxPolicy policy;
    rubric::Rubric rubric;
    std::string toolVersion;
    /// The option to judge, by its name; other files' tasks count as not attempted. Empty: all.
    std::string option = {};
    /// Only one submission is graded: independent steps may run in parallel.
    bool isAlone = false;
    std::vector<SpecScene> scenes = {};  ///< rendered for people to look at; may be empty
    std::string build = {};       ///< digest of the tool itself, see Inputs.h; empty: unknown
    std::string rubricText = {};  ///< the file that `rubric` was read from
    const Exercise* exercise = &theExercise();
    std::span<const Task> tasks = tasks::theTasks();  ///< the code of the exercise's tasks
};

/// Judges one submission: builds each file that was worked on, asks it, applies the rubric.
///
/// What the submission does, or fails to do, is in the result. The exercise's tasks
/// and "screenshot" are always there, in this order.
///
/// @param seed  Hidden questions are drawn from it, after the submission was compiled.
/// @throws raytracer::Error where it could not be graded for reasons that are ours.
[[nodiscard]] SubmissionResult gradeSubmission(const intake::Submission& submission,
                                               const Grader& grader, std::uint64_t seed);

/// The result of a submission that could not be graded for reasons that are ours: every task
/// notGraded.
[[nodiscard]] SubmissionResult notGradedResult(const std::string& name, const std::string& reason,
                                               const Grader& grader, std::uint64_t seed);

}  // namespace ticker::pipeline

#endif
