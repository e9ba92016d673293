#include <grader/cli/Formats.h>

#include <grader/base/WholeFile.h>
#include <grader/cli/CanvasFormat.h>
#include <grader/cli/Output.h>
#include <grader/cli/verbs/StudentPages.h>
#include <grader/report/platforms/MoodleWorksheet.h>
#include <grader/report/platforms/PlatformFormats.h>
#include <grader/result/ResultJson.h>
#include <grader/zip/ZipWriter.h>

#include <raytracer/base/Error.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;
using report::StudentView;

/// A format with one file for each submission.
struct EachFile {
    const char* name;
    std::function<std::optional<std::string>(const StudentView&)> render;
};

const std::map<std::string, std::vector<EachFile>>& eachFormats() {
    static const std::map<std::string, std::vector<EachFile>> kFormats{
        {"gradescope", {{"gradescope.json", report::gradescopeJson}}},
        {"prairielearn", {{"prairielearn.json", report::prairieLearnJson}}},
        {"classroom",
         {{"classroom.json", report::classroomJson}, {"classroom.md", report::classroomSummary}}},
        {"github", {{"annotations.txt", report::gitHubAnnotations}}},
        {"autolab", {{"autolab.txt", report::autolabLines}}},
        {"junit", {{"junit.xml", report::junitXml}}},
    };
    return kFormats;
}

/// A format with one file for the class, for staff.
struct ClassFormat {
    const char* file;
    std::function<std::string(const std::vector<store::ClassEntry>&)> render;
};

const std::map<std::string, ClassFormat>& classFormats() {
    static const std::map<std::string, ClassFormat> kFormats{
        {"csv", {"summary.csv", summaryOf}},
        {"json",
         {"results.json",
          [](const std::vector<store::ClassEntry>& entries) {
              return allResultsJson(resultsOf(entries));
          }}},
    };
    return kFormats;
}

/// No person has decided about these files.
bool isOpen(const store::ClassEntry& entry) {
    return !isDecided(entry) || isStale(entry);
}

std::vector<StudentView> viewsOf(const std::vector<store::ClassEntry>& entries,
                                 const report::StudentPolicy& policy) {
    std::vector<StudentView> views;
    for (const store::ClassEntry& entry : entries)
        views.push_back(studentViewOf(entry, policy));
    return views;
}

void tell(const report::MoodleGrades& grades, const std::vector<store::ClassEntry>& entries) {
    for (const std::string& remark : grades.remarks)
        fmt::print(stderr, "{}\n", remark);
    for (const std::string& warning : grades.warnings)
        fmt::print(stderr, "ticker: {}\n", warning);
    const auto proposals = std::ranges::count_if(
        grades.graded, [&](const auto& graded) { return !isDecided(entries.at(graded.view)); });
    if (proposals > 0)
        fmt::print(stderr,
                   "ticker: {} of the {} marks are proposals of ticker, without a person's "
                   "decision; "
                   "--decided-only leaves them out\n",
                   proposals, grades.graded.size());
    fmt::print(stderr,
               "{} graded. Upload the worksheet first, then the zip; before any later upload "
               "download a fresh worksheet, or Moodle silently skips rows.\n",
               grades.graded.size());
}

std::vector<fs::path> writeMoodle(const fs::path& out, std::vector<store::ClassEntry> entries,
                                  const report::StudentPolicy& policy,
                                  const FormatOptions& options) {
    if (options.worksheet.empty())
        throw raytracer::InputError("--format moodle", 0,
                                    "needs --worksheet FILE: Moodle's grading worksheet, freshly "
                                    "downloaded");
    if (options.decidedOnly) std::erase_if(entries, isOpen);
    const std::vector<StudentView> views = viewsOf(entries, policy);
    std::vector<std::string> pages;
    for (const store::ClassEntry& entry : entries)
        pages.push_back(studentPageOf(out, entry, policy));
    std::optional<report::ScaleWords> scale;
    if (!options.scale.empty())
        scale = report::ScaleWords{options.scale.at(0), options.scale.at(1)};
    const report::MoodleGrades grades = report::fillMoodleWorksheet(
        readWhole(options.worksheet, "cannot be read; expected Moodle's grading worksheet"),
        options.worksheet, views, scale);
    const fs::path sheet = out / "moodle-worksheet.csv";
    const fs::path feedback = out / "moodle-feedback.zip";
    writeAtomically(grades.worksheet, sheet);
    zip::ZipWriter zip{feedback};
    for (const report::NamedText& file : report::moodleFeedbackFiles(grades.graded, views, pages))
        zip.add(file.path, file.text);
    zip.finish();
    tell(grades, entries);
    return {sheet, feedback};
}

/// Writes the page of each submission and the page of the class.
std::vector<fs::path> writePages(const fs::path& out, const std::vector<store::ClassEntry>& entries,
                                 const FormatOptions& options) {
    std::vector<fs::path> written = writeStudentPages(out, entries, options.studentView);
    for (const store::ClassEntry& entry : entries)
        written.push_back(rewriteReport(out, entry.result));
    written.push_back(out / "index.html");
    writeAtomically(classPageOf(store::readClass(out)), written.back());
    return written;
}

std::vector<fs::path> writeEach(const fs::path& out, const std::vector<store::ClassEntry>& entries,
                                const report::StudentPolicy& policy, const EachFile& format) {
    std::vector<fs::path> written;
    for (const store::ClassEntry& entry : entries) {
        const fs::path file = out / entry.result.submission / format.name;
        std::error_code ignored;
        if (const auto text = format.render(studentViewOf(entry, policy))) {
            writeAtomically(*text, file);
            written.push_back(file);
        } else {
            fs::remove(file, ignored);
        }
    }
    return written;
}

}  // namespace

void addFormatOptions(CLI::App& verb, FormatOptions& options) {
    verb.add_option("--worksheet", options.worksheet,
                    "For moodle: its grading worksheet, freshly downloaded; for canvas: the "
                    "exported gradebook");
    verb.add_option("--assignment", options.assignment,
                    "For canvas: the assignment's name or id in the gradebook");
    verb.add_option("--download", options.download,
                    "For canvas: the zip of its submissions, to write comments under its names");
    verb.add_option("--scale", options.scale,
                    "For moodle, where a scale is used: its words for not awarded and awarded")
        ->delimiter(',')
        ->expected(2);
    verb.add_flag(
        "--decided-only", options.decidedOnly,
        "For moodle and canvas: only those about whose newest files a person has decided");
    addStudentView(verb, options.studentView);
}

std::vector<std::string> formatNames() {
    std::vector<std::string> names{"canvas", "html", "moodle"};
    for (const auto& [name, unused] : eachFormats())
        names.push_back(name);
    for (const auto& [name, unused] : classFormats())
        names.push_back(name);
    std::ranges::sort(names);
    return names;
}

std::vector<std::string> submissionFiles() {
    std::vector<std::string> names{"student.html"};
    for (const auto& [unused, files] : eachFormats())
        for (const EachFile& file : files)
            names.emplace_back(file.name);
    return names;
}

std::vector<fs::path> writeFormats(const fs::path& out,
                                   const std::vector<store::ClassEntry>& entries,
                                   const FormatOptions& options) {
    std::vector<fs::path> written;
    for (const std::string& name : options.names) {
        std::vector<fs::path> files;
        if (const auto whole = classFormats().find(name); whole != classFormats().end()) {
            files = {out / whole->second.file};
            writeAtomically(whole->second.render(entries), files.front());
        } else if (name == "html") {
            files = writePages(out, entries, options);
        } else if (name == "moodle") {
            files = writeMoodle(out, entries, policyFrom(options.studentView), options);
        } else if (name == "canvas") {
            std::vector<store::ClassEntry> chosen = entries;
            if (options.decidedOnly) std::erase_if(chosen, isOpen);
            files = writeCanvas(out, viewsOf(chosen, policyFrom(options.studentView)), options);
        } else {
            for (const EachFile& file : eachFormats().at(name))
                std::ranges::move(writeEach(out, entries, policyFrom(options.studentView), file),
                                  std::back_inserter(files));
        }
        std::ranges::move(files, std::back_inserter(written));
    }
    warnOfStale(entries, options.decidedOnly);
    return written;
}

}  // namespace ticker::cli
