#include <grader/cli/Output.h>
#include <grader/report/ClassPage.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportPage.h>
#include <grader/report/ResultJson.h>
#include <grader/report/SummaryCsv.h>
#include <grader/result/Names.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <algorithm>
#include <system_error>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

void makeFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw raytracer::InputError(folder.string(), 0, "cannot be made: " + error.message());
}

std::string findingsText(const SubmissionResult& result) {
    std::string text;
    for (const TaskReport& task : result.tasks)
        for (const Finding& finding : task.findings)
            if (finding.severity != Severity::note) text += " " + finding.id;
    return text;
}

}  // namespace

void writeSubmission(const fs::path& out, const SubmissionResult& result) {
    const fs::path folder = out / result.submission;
    makeFolder(folder / "images");
    for (const ResultPicture& picture : result.pictures)
        report::writeAtomically(picture.png, folder / picture.file);
    report::writeAtomically(report::reportPage(result), folder / "report.html");
    report::writeAtomically(report::resultJson(result), folder / "result.json");
}

void writeClass(const fs::path& out, std::vector<SubmissionResult> results) {
    std::sort(results.begin(), results.end(),
              [](const SubmissionResult& a, const SubmissionResult& b) {
                  return a.submission < b.submission;
              });
    makeFolder(out);
    report::writeAtomically(report::summaryCsv(results), out / "summary.csv");
    report::writeAtomically(report::classPage(results), out / "index.html");
}

std::vector<SubmissionResult> readResults(const fs::path& out) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{out, error})
        if (fs::is_regular_file(entry.path() / "result.json", error))
            files.push_back(entry.path() / "result.json");
    if (files.empty())
        throw raytracer::InputError(out.string(), 0,
                                    "holds no results; expected the OUT of ticker grade");
    std::sort(files.begin(), files.end());
    std::vector<SubmissionResult> results;
    for (const fs::path& file : files)
        results.push_back(report::readResultJson(file));
    return results;
}

std::string allResultsJson(const std::vector<SubmissionResult>& results) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < results.size(); ++i)
        text += report::resultJson(results[i]) + (i + 1 < results.size() ? "," : "");
    return text + "]\n";
}

std::string tableLine(const SubmissionResult& result) {
    std::string states;
    for (const TaskReport& task : result.tasks)
        if (task.state != TaskState::notAttempted && task.id != "screenshot")
            states += fmt::format(" {} {}", task.id, toString(task.state));
    return fmt::format("{:<12} {:<36}{}{}", toString(result.verdict),
                       report::escapeLine(result.submission),
                       states.empty() ? " not attempted" : states,
                       findingsText(result).empty() ? "" : ":" + findingsText(result));
}

}  // namespace ticker::cli
