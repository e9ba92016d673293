#include <grader/base/MakeFolder.h>
#include <grader/base/WholeFile.h>
#include <grader/cli/Formats.h>
#include <grader/cli/Output.h>
#include <grader/exercise/Exercise.h>
#include <grader/report/ClassPage.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportPage.h>
#include <grader/report/SummaryCsv.h>
#include <grader/result/Names.h>
#include <grader/result/ResultJson.h>
#include <grader/result/Tally.h>
#include <grader/store/ClassFolder.h>
#include <grader/store/Earlier.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <algorithm>
#include <system_error>
#include <utility>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

// What would stay could pass for a part of the new hand-in.
void removeWhole(const fs::path& path) {
    std::error_code error;
    fs::remove_all(path, error);
    if (error)
        throw raytracer::InputError(path.string(), 0, "cannot be removed: " + error.message());
}

// Removes the files of an earlier grading, also those for students and platforms: one that is not
// made anew would tell of the earlier result. result.json goes first, because without it the rest
// does not count as a result.
void clear(const fs::path& folder) {
    for (const char* name : {"result.json", "images", "code"})
        removeWhole(folder / name);
    for (const std::string& name : submissionFiles())
        removeWhole(folder / name);
    removeWhole(keptScreenshot(folder).parent_path());
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, ignored})
        if (entry.path().extension() == ".part") fs::remove(entry.path(), ignored);
}

std::string findingsText(const SubmissionResult& result) {
    std::string text;
    for (const std::string& id : findingIds(result))
        text += " " + id;
    return text;
}

std::vector<Decision> decisionsOf(const std::vector<store::ClassEntry>& entries) {
    std::vector<Decision> decisions;
    for (const store::ClassEntry& entry : entries)
        if (entry.decision) decisions.push_back(*entry.decision);
    return decisions;
}

}  // namespace

fs::path keptScreenshot(const fs::path& folder) {
    return folder / "handed-in" / kScreenshotPart;
}

void writeSubmission(const fs::path& out, const SubmissionResult& result) {
    const fs::path folder = out / result.submission;
    makeFolder(folder);
    store::keepEarlier(out, result);
    clear(folder);
    makeFolder(folder / "images");
    makeFolder(folder / "code");
    for (const ResultPicture& picture : result.pictures)
        writeAtomically(picture.png, folder / picture.file);
    for (const SourceText& source : result.sources)
        writeAtomically(source.bytes, folder / "code" / source.file);
    makeFolder(keptScreenshot(folder).parent_path());
    if (result.screenshot) writeAtomically(*result.screenshot, keptScreenshot(folder));
    // The page shows the contents of result.json, so that it can be written again from there.
    const std::string json = resultJson(result);
    SubmissionResult told = parseResultJson(json, "result.json");
    told.pictures = result.pictures;
    told.sources = result.sources;
    writeAtomically(report::reportPage(told), folder / "report.html");
    writeAtomically(json, folder / "result.json");
}

std::string summaryOf(const std::vector<store::ClassEntry>& entries) {
    return report::summaryCsv(resultsOf(entries), decisionsOf(entries));
}

std::string classPageOf(const std::vector<store::ClassEntry>& entries) {
    return report::classPage(resultsOf(entries), decisionsOf(entries));
}

void writeClass(const fs::path& out, const std::vector<store::ClassEntry>& entries) {
    writeAtomically(summaryOf(entries), out / "summary.csv");
    writeAtomically(classPageOf(entries), out / "index.html");
}

std::vector<SubmissionResult> resultsOf(std::vector<store::ClassEntry> entries) {
    std::vector<SubmissionResult> results;
    for (store::ClassEntry& entry : entries)
        results.push_back(std::move(entry.result));
    return results;
}

std::vector<SubmissionResult> readResults(const fs::path& out) {
    return resultsOf(store::readClass(out));
}

void fetchFiles(const fs::path& out, SubmissionResult& result) {
    const fs::path folder = out / result.submission;
    for (ResultPicture& picture : result.pictures)
        picture.png = readIfThere(folder / picture.file).value_or("");
    for (const Diagnostics& said : result.diagnostics)
        fetchSource(out, said.file, result);
}

void fetchSource(const fs::path& out, const std::string& file, SubmissionResult& result) {
    if (std::ranges::find(result.sources, file, &SourceText::file) != result.sources.end()) return;
    const fs::path path = out / result.submission / "code" / fs::path{file}.filename();
    result.sources.push_back({file, readIfThere(path).value_or("")});
}

fs::path rewriteReport(const fs::path& out, SubmissionResult result) {
    fetchFiles(out, result);
    const fs::path file = out / result.submission / "report.html";
    writeAtomically(report::reportPage(result), file);
    return file;
}

std::string allResultsJson(const std::vector<SubmissionResult>& results) {
    std::string text = "[\n";
    for (std::size_t i = 0; i < results.size(); ++i)
        text += resultJson(results[i]) + (i + 1 < results.size() ? "," : "");
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
