#ifndef TICKER_PIPELINE_GRADE_H
#define TICKER_PIPELINE_GRADE_H

#include <grader/build/Kit.h>
#include <grader/intake/Submission.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/result/SubmissionResult.h>
#include <grader/rubric/Rubric.h>
#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// Which option to judge; the other one's tasks count as not attempted.
enum class OptionChoice { automatic, t1, t2 };

/// What all submissions of a batch share. Never changes, so threads may share it.
struct Grader {
    build::Kit kit;
    sandbox::Sandbox sandbox;
    sandbox::SandboxPolicy policy;
    rubric::Rubric rubric;
    std::string toolVersion;
    OptionChoice option = OptionChoice::automatic;
    /// Nobody else is graded meanwhile: what does not depend on each other may run side by side.
    bool isAlone = false;
    std::vector<SpecScene> scenes = {};  ///< rendered for people to look at; may be empty
    std::string build = {};       ///< digest of the tool itself, see Inputs.h; empty: unknown
    std::string rubricText = {};  ///< the file that `rubric` was read from
};

/// Judges one submission: builds each file that was worked on, asks it, applies the rubric.
///
/// What the submission does, or fails to do, is in the result. Tasks "T1", "T2.1", "T2.2" and
/// "screenshot" are always there, in this order.
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
