#ifndef TICKER_PIPELINE_INPUTS_H
#define TICKER_PIPELINE_INPUTS_H

#include <grader/intake/Submission.h>
#include <grader/pipeline/Grade.h>
#include <grader/result/Inputs.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// Digest of the running program, the kit that it compiles submissions with, and the files that lie
/// in folders of data.
[[nodiscard]] std::string toolBuild(const build::Kit& kit,
                                    const std::vector<std::filesystem::path>& data);

/// What the result of this submission will depend on.
[[nodiscard]] Inputs inputsOf(const intake::Submission& submission, const Grader& grader,
                              std::uint64_t seed);

/// What a submission's hidden questions are drawn from: the class's seed and the files themselves.
/// The same files get the same questions under one seed, whatever the submission is called; other
/// files get others, which no earlier report tells.
[[nodiscard]] std::uint64_t questionSeed(const intake::Submission& submission, std::uint64_t seed,
                                         const Exercise& exercise = theExercise());

}  // namespace ticker::pipeline

#endif
