#ifndef TICKER_CLI_OUTPUT_H
#define TICKER_CLI_OUTPUT_H

#include <grader/result/SubmissionResult.h>
#include <grader/store/ClassFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::cli {

/// Writes `OUT/<submission>/`: images/, code/ (the sources as handed in), report.html and, last,
/// result.json, which says that the rest is there. What an earlier grading left goes first.
/// @throws raytracer::InputError where something cannot be written.
void writeSubmission(const std::filesystem::path& out, const SubmissionResult& result);

/// Writes OUT/summary.csv and OUT/index.html, in the order of the submissions' names.
void writeClass(const std::filesystem::path& out, std::vector<SubmissionResult> results);

/// What the tool says of a class.
[[nodiscard]] std::vector<SubmissionResult> resultsOf(std::vector<store::ClassEntry> entries);

/// All results below OUT, by name.
/// @throws raytracer::InputError where OUT holds none, or one cannot be read.
[[nodiscard]] std::vector<SubmissionResult> readResults(const std::filesystem::path& out);

/// All results as one JSON array of what result.json holds.
[[nodiscard]] std::string allResultsJson(const std::vector<SubmissionResult>& results);

/// Brings back what lies beside a result.json: the bytes of pictures, the sources that the compiler
/// spoke of. What cannot be read stays empty.
void fetchFiles(const std::filesystem::path& out, SubmissionResult& result);

/// Writes the submission's report.html anew, from a result that was read back and the files beside
/// it.
/// @return The file.
/// @throws raytracer::InputError where it cannot be written.
std::filesystem::path rewriteReport(const std::filesystem::path& out, SubmissionResult result);

/// One line of a table for a person: verdict, task states, findings.
[[nodiscard]] std::string tableLine(const SubmissionResult& result);

}  // namespace ticker::cli

#endif
