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
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

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

/// The folders below OUT that hold a result, by name.
std::vector<fs::path> resultFolders(const fs::path& out) {
    std::error_code error;
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator{out, error})
        if (fs::is_regular_file(entry.path() / "result.json", error))
            folders.push_back(entry.path());
    if (folders.empty())
        throw raytracer::InputError(out.string(), 0,
                                    "holds no results; expected the OUT of ticker grade");
    std::sort(folders.begin(), folders.end());
    return folders;
}

/// Brings the pictures back that lie beside a result. A page links to one that cannot be read.
void fetchPictures(const fs::path& folder, SubmissionResult& result) {
    for (ResultPicture& picture : result.pictures) {
        std::ifstream stream{folder / picture.file, std::ios::binary};
        picture.png.assign(std::istreambuf_iterator<char>{stream}, {});
    }
}

}  // namespace

void writeSubmission(const fs::path& out, const SubmissionResult& result) {
    const fs::path folder = out / result.submission;
    makeFolder(folder / "images");
    for (const ResultPicture& picture : result.pictures)
        report::writeAtomically(picture.png, folder / picture.file);
    // The page shows what result.json says, so that it can be made again from there.
    const std::string json = report::resultJson(result);
    SubmissionResult told = report::parseResultJson(json, "result.json");
    told.pictures = result.pictures;
    report::writeAtomically(report::reportPage(told), folder / "report.html");
    report::writeAtomically(json, folder / "result.json");
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
    std::vector<SubmissionResult> results;
    for (const fs::path& folder : resultFolders(out))
        results.push_back(report::readResultJson(folder / "result.json"));
    return results;
}

void rewritePages(const fs::path& out, const std::string& submission) {
    std::vector<SubmissionResult> results;
    bool found = submission.empty();
    for (const fs::path& folder : resultFolders(out)) {
        SubmissionResult result = report::readResultJson(folder / "result.json");
        if (submission.empty() || result.submission == submission) {
            found = true;
            fetchPictures(folder, result);
            report::writeAtomically(report::reportPage(result), folder / "report.html");
        }
        for (ResultPicture& picture : result.pictures)
            picture.png.clear();  // a class of them is more than memory has to hold
        results.push_back(std::move(result));
    }
    if (!found) throw noSuchSubmission(out, submission);
    report::writeAtomically(report::classPage(results), out / "index.html");
}

raytracer::InputError noSuchSubmission(const fs::path& out, const std::string& submission) {
    return {out.string(), 0, fmt::format("no result of a submission named \"{}\"", submission)};
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
