#include <grader/cli/Formats.h>

#include <grader/cli/Home.h>
#include <grader/cli/Output.h>
#include <grader/report/ClassPage.h>
#include <grader/report/MoodleWorksheet.h>
#include <grader/report/PlatformFormats.h>
#include <grader/report/ResultJson.h>
#include <grader/report/StudentPage.h>
#include <grader/zip/ZipWriter.h>

#include <raytracer/base/Error.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;
using report::StudentView;

/// A file of each submission.
struct EachFormat {
    const char* file;
    std::function<std::optional<std::string>(const StudentView&)> render;
};

const std::map<std::string, EachFormat>& eachFormats() {
    static const std::map<std::string, EachFormat> kFormats{
        {"gradescope", {"gradescope.json", report::gradescopeJson}},
        {"prairielearn", {"prairielearn.json", report::prairieLearnJson}},
        {"classroom", {"classroom.json", report::classroomJson}},
        {"autolab", {"autolab.txt", report::autolabLines}},
        {"junit", {"junit.xml", report::junitXml}},
    };
    return kFormats;
}

/// A file of the class, for staff.
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

report::StudentPolicy policyOf(const FormatOptions& options) {
    return report::readStudentPolicy(options.studentView.empty() ? Home::find().studentView()
                                                                 : fs::path{options.studentView});
}

std::string readText(const fs::path& file, const char* expected) {
    std::ifstream stream{file, std::ios::binary};
    if (!stream)
        throw raytracer::InputError(file.string(), 0,
                                    fmt::format("cannot be read; expected {}", expected));
    return {std::istreambuf_iterator<char>{stream}, {}};
}

/// The result as it counts: as a person decided, or as the tool proposes.
SubmissionResult decided(const store::ClassEntry& entry) {
    SubmissionResult result = entry.result;
    if (!entry.decision || entry.decision->ruling == Ruling::undecided) return result;
    const bool isAwarded = entry.decision->ruling == Ruling::awarded;
    result.verdict = isAwarded ? Verdict::awarded : Verdict::notAwarded;
    if (!isAwarded)
        result.score = 0.0;
    else if (result.score <= 0.0)
        result.score = result.maxScore;
    return result;
}

StudentView viewOf(SubmissionResult result, const store::ClassEntry& entry,
                   const report::StudentPolicy& policy) {
    return {std::move(result), policy, entry.decision ? entry.decision->comment : "",
            entry.result.verdict};
}

std::vector<fs::path> writeMoodle(const fs::path& out,
                                  const std::vector<store::ClassEntry>& entries,
                                  const report::StudentPolicy& policy,
                                  const FormatOptions& options) {
    if (options.worksheet.empty())
        throw raytracer::InputError("--format moodle", 0,
                                    "needs --worksheet FILE: Moodle's grading worksheet, freshly "
                                    "downloaded");
    std::vector<StudentView> views;
    std::vector<std::string> pages;
    for (const store::ClassEntry& entry : entries) {
        SubmissionResult result = decided(entry);
        views.push_back(viewOf(result, entry, policy));
        fetchFiles(out, result);
        pages.push_back(report::studentPage(viewOf(std::move(result), entry, policy)));
    }
    std::optional<report::ScaleWords> scale;
    if (!options.scale.empty())
        scale = report::ScaleWords{options.scale.at(0), options.scale.at(1)};
    const report::MoodleGrades grades = report::fillMoodleWorksheet(
        readText(options.worksheet, "Moodle's grading worksheet"), options.worksheet, views, scale);
    const fs::path sheet = out / "moodle-worksheet.csv";
    const fs::path feedback = out / "moodle-feedback.zip";
    report::writeAtomically(grades.worksheet, sheet);
    zip::ZipWriter zip{feedback};
    for (const report::NamedText& file : report::moodleFeedbackFiles(grades.graded, views, pages))
        zip.add(file.path, file.text);
    zip.finish();
    for (const std::string& remark : grades.remarks)
        fmt::print(stderr, "{}\n", remark);
    fmt::print(stderr,
               "{} graded. Upload the worksheet first, then the zip; before any later upload "
               "download a fresh worksheet, or Moodle silently skips rows.\n",
               grades.graded.size());
    return {sheet, feedback};
}

/// The page of each submission, and that of the whole class.
std::vector<fs::path> writePages(const fs::path& out,
                                 const std::vector<store::ClassEntry>& entries) {
    std::vector<fs::path> written;
    for (const store::ClassEntry& entry : entries)
        written.push_back(rewriteReport(out, entry.result));
    written.push_back(out / "index.html");
    report::writeAtomically(report::classPage(readResults(out)), written.back());
    return written;
}

std::vector<fs::path> writeEach(const fs::path& out, const std::vector<store::ClassEntry>& entries,
                                const report::StudentPolicy& policy, const EachFormat& format) {
    std::vector<fs::path> written;
    for (const store::ClassEntry& entry : entries) {
        const fs::path file = out / entry.result.submission / format.file;
        std::error_code ignored;
        if (const auto text = format.render(viewOf(decided(entry), entry, policy))) {
            report::writeAtomically(*text, file);
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
                    "For moodle: its grading worksheet, freshly downloaded");
    verb.add_option("--scale", options.scale,
                    "For moodle, where a scale is used: its words for not awarded and awarded")
        ->delimiter(',')
        ->expected(2);
    verb.add_option("--student-view", options.studentView,
                    "What students may see, instead of the kit's own policy");
}

std::vector<std::string> formatNames() {
    std::vector<std::string> names{"html", "moodle"};
    for (const auto& [name, unused] : eachFormats())
        names.push_back(name);
    for (const auto& [name, unused] : classFormats())
        names.push_back(name);
    std::ranges::sort(names);
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
            report::writeAtomically(whole->second.render(entries), files.front());
        } else if (name == "html") {
            files = writePages(out, entries);
        } else if (name == "moodle") {
            files = writeMoodle(out, entries, policyOf(options), options);
        } else {
            files = writeEach(out, entries, policyOf(options), eachFormats().at(name));
        }
        std::ranges::move(files, std::back_inserter(written));
    }
    return written;
}

}  // namespace ticker::cli
