#ifndef TICKER_CLI_OUTPUT_H
#define TICKER_CLI_OUTPUT_H

#include <grader/result/SubmissionResult.h>
#include <grader/store/ClassFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::cli {

/// The screenshot's bytes as they were handed in, below `OUT/<submission>/`. They decide which
/// questions are asked; images/ has only the decoded picture. Untrusted: for grading again, never
/// for a page. The file is missing where there was no screenshot, its folder where a ticker graded
/// that did not keep it yet.
[[nodiscard]] std::filesystem::path keptScreenshot(const std::filesystem::path& folder);

/// Writes `OUT/<submission>/`: images/, code/ (the submitted sources), handed-in/ (the screenshot's
/// bytes), report.html and, last, result.json, which marks the folder as complete. Files of an
/// earlier grading are removed first, once what `store::keepEarlier` keeps is safe.
/// @throws raytracer::InputError if a file cannot be written, moved or removed.
void writeSubmission(const std::filesystem::path& out, const SubmissionResult& result);

/// Writes OUT/summary.csv and OUT/index.html.
/// @param entries  The whole class.
/// @throws raytracer::InputError if a file cannot be written.
void writeClass(const std::filesystem::path& out, const std::vector<store::ClassEntry>& entries);

/// The text of summary.csv: the tool's verdicts and the tickers' decisions.
[[nodiscard]] std::string summaryOf(const std::vector<store::ClassEntry>& entries);

/// The text of index.html.
[[nodiscard]] std::string classPageOf(const std::vector<store::ClassEntry>& entries);

/// The tool's results of a class.
[[nodiscard]] std::vector<SubmissionResult> resultsOf(std::vector<store::ClassEntry> entries);

/// All results below OUT, by name.
/// @throws raytracer::InputError if OUT has no results, or one cannot be read.
[[nodiscard]] std::vector<SubmissionResult> readResults(const std::filesystem::path& out);

/// All results as one JSON array; each element has the contents of a result.json.
[[nodiscard]] std::string allResultsJson(const std::vector<SubmissionResult>& results);

/// Reads the files beside a result.json: the bytes of pictures, the sources that diagnostics refer
/// to. Data that cannot be read stays empty.
void fetchFiles(const std::filesystem::path& out, SubmissionResult& result);

/// Reads one source back, unless it is there.
void fetchSource(const std::filesystem::path& out, const std::string& file,
                 SubmissionResult& result);

/// Writes the submission's report.html again, from its result.json and the files beside it.
/// @return  The file.
/// @throws raytracer::InputError if it cannot be written.
std::filesystem::path rewriteReport(const std::filesystem::path& out, SubmissionResult result);

/// One line of a table: verdict, task states, findings.
[[nodiscard]] std::string tableLine(const SubmissionResult& result);

}  // namespace ticker::cli

#endif
