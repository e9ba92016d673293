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

/// One file after its tasks were judged: a screenshot is compared with its renders.
struct JudgedFile {
    std::string file;
    bool isAttempted = false;
    std::optional<build::Program> program;  ///< present if it can render
    std::vector<Rendered> renders;
};

/// Judges screenshot.png: first the file (missing, not decodable), then its contents and whether
/// the submission's own code rendered it. The decoded picture is encoded again and added to the
/// result.
///
/// @param bytes   Empty if no screenshot was handed in.
/// @param budget  Time left for the submission's own renders.
/// @param files   The scenes of all attempted options are accepted; if nothing was attempted, all
///                scenes.
[[nodiscard]] TaskReport judgeScreenshotFile(const std::optional<std::string>& bytes,
                                             const std::vector<JudgedFile>& files,
                                             const Grader& grader, build::TimeBudget& budget,
                                             std::uint64_t seed, SubmissionResult& result);

}  // namespace ticker::pipeline

#endif
