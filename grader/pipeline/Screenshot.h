#ifndef TICKER_PIPELINE_SCREENSHOT_H
#define TICKER_PIPELINE_SCREENSHOT_H

#include <grader/build/Program.h>
#include <grader/build/TimeBudget.h>
#include <grader/pipeline/FileWork.h>
#include <grader/pipeline/Grade.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// One file after its tasks were judged: what a screenshot is compared with.
struct JudgedFile {
    std::string file;
    bool isAttempted = false;
    std::optional<build::Program> program;  ///< there, where it renders
    std::vector<Rendered> renders;
};

/// Judges screenshot.png: the file (missing, not to be decoded), then what it shows and whether the
/// submission's own code made it. The picture goes into the result, decoded and packed anew.
///
/// @param bytes  Empty optional: none was handed in.
/// @param budget  What is left for the submission's own renders.
/// @param files  Every attempted option's scene may be shown; where nothing was attempted, each.
[[nodiscard]] TaskReport judgeScreenshotFile(const std::optional<std::string>& bytes,
                                             const std::vector<JudgedFile>& files,
                                             const Grader& grader, build::TimeBudget& budget,
                                             std::uint64_t seed, SubmissionResult& result);

}  // namespace ticker::pipeline

#endif
