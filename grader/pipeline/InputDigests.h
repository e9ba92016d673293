#ifndef TICKER_PIPELINE_INPUTDIGESTS_H
#define TICKER_PIPELINE_INPUTDIGESTS_H

#include <grader/intake/Submission.h>
#include <grader/pipeline/Grade.h>
#include <grader/result/ResultInputs.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::pipeline {

/// Digest of the running program and its helpers, of the kit that compiles submissions with its
/// stubs, and of the files in the data folders.
/// @throws raytracer::Error if a helper is missing.
[[nodiscard]] std::string toolBuild(const build::Kit& kit,
                                    const std::vector<std::filesystem::path>& data);

/// Digests of everything on which this submission's result depends.
[[nodiscard]] Inputs inputsOf(const intake::Submission& submission, const Grader& grader,
                              std::uint64_t seed);

/// Digest of how submissions are judged: rubric, sandbox level, exercise, option, seed. It is
/// `Inputs::how` of a result at this level and seed.
[[nodiscard]] std::string howDigest(const Grader& grader, std::string_view sandboxLevel,
                                    std::uint64_t seed);

/// Seed of a submission's hidden questions, from the class's seed and the submitted files. Under
/// one seed, equal files get equal questions, whatever the submission's name. Other files get other
/// questions, which no earlier report reveals.
[[nodiscard]] std::uint64_t questionSeed(const intake::Submission& submission, std::uint64_t seed,
                                         const Exercise& exercise = defaultExercise());

}  // namespace ticker::pipeline

#endif
