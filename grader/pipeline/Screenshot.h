#ifndef TICKER_PIPELINE_SCREENSHOT_H
#define TICKER_PIPELINE_SCREENSHOT_H

#include <grader/build/Program.h>
#include <grader/build/TimeBudget.h>
#include <grader/picture/DecodePicture.h>
#include <grader/pipeline/FileWork.h>
#include <grader/pipeline/Grade.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstddef>
#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace ticker::pipeline {

/// A run that the judgement of the screenshot needs, made beside the runs for the tasks.
struct AskedAhead {
    std::vector<std::byte> questions;  ///< encoded
    probe::Run run;
    double wallMs = 0.0;
    bool madeForbiddenCall = false;
};

/// The questions that `judgeScreenshotFile` puts to a file's program first. Empty if that depends
/// on more than the picture's size: on another file, or on which of two scenes the picture shows.
/// @param seed  As for `judgeScreenshotFile`.
[[nodiscard]] std::vector<probe::Question> firstQuestions(const intake::Submission& submission,
                                                          const std::string& file,
                                                          const Grader& grader, std::uint64_t seed);

[[nodiscard]] AskedAhead askAhead(const std::vector<probe::Question>& questions,
                                  const build::Program& program, const Grader& grader,
                                  build::TimeBudget& budget);

/// One file after its tasks were judged: a screenshot is compared with its renders.
struct JudgedFile {
    std::string file;
    bool isAttempted = false;
    std::optional<build::Program> program;  ///< present if it can render
    std::vector<Rendered> renders;
    std::optional<AskedAhead> ahead = {};
};

/// Decodes screenshot.png: at once if the submission is graded alone, otherwise when the pixels are
/// requested. Without a file the future is invalid.
/// @param bytes  Must outlive the future.
[[nodiscard]] std::future<picture::Decoded> beginDecoding(const std::optional<std::string>& bytes,
                                                          const Grader& grader);

/// Judges screenshot.png: first the file (missing, not decodable), then its contents and whether
/// the submission's own code rendered it. The decoded picture is encoded again and added to the
/// result.
///
/// @param picture  From `beginDecoding`.
/// @param budget  Time left for the submission's own renders.
/// @param files   The scenes of all attempted options are accepted; if nothing was attempted, all
///                scenes.
[[nodiscard]] TaskReport judgeScreenshotFile(std::future<picture::Decoded> picture,
                                             const std::vector<JudgedFile>& files,
                                             const Grader& grader, build::TimeBudget& budget,
                                             std::uint64_t seed, SubmissionResult& result);

}  // namespace ticker::pipeline

#endif
