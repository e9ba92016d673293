#ifndef TICKER_CLI_CANVASFORMAT_H
#define TICKER_CLI_CANVASFORMAT_H

#include <grader/cli/Formats.h>
#include <grader/report/student/StudentView.h>

#include <filesystem>
#include <vector>

namespace ticker::cli {

/// Writes OUT/canvas-gradebook.csv and, where the downloaded submissions are given,
/// OUT/canvas-comments.zip: students' files under the names that Canvas gave them, each with a
/// comment at its top.
/// @throws raytracer::InputError if a file cannot be read or written, or an option is missing.
[[nodiscard]] std::vector<std::filesystem::path> writeCanvas(
    const std::filesystem::path& out, const std::vector<report::StudentView>& views,
    const FormatOptions& options);

}  // namespace ticker::cli

#endif
