#include <grader/cli/CanvasFormat.h>

#include <grader/base/WholeFile.h>
#include <grader/intake/CanvasName.h>
#include <grader/intake/ClassExport.h>
#include <grader/intake/Contents.h>
#include <grader/report/platforms/CanvasGradebook.h>
#include <grader/report/platforms/SubmissionId.h>
#include <grader/zip/ZipWriter.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <cstdio>
#include <map>
#include <optional>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// A student's source file in the download.
struct HandedIn {
    std::string name;  ///< as Canvas named it
    std::string bytes;
};

/// The names of the downloaded files, by what intake calls their owner.
std::multimap<std::string, std::string> namesByOwner(const fs::path& download) {
    const intake::MemberList members = intake::listArchive(download);
    std::multimap<std::string, std::string> names;
    for (const std::string& name : members.paths)
        if (const auto parts = intake::readCanvasName(name)) names.emplace(parts->owner, name);
    if (!names.empty() && !members.damage.empty())
        throw intake::damagedDownload(download, members.damage);
    return names;
}

/// The first source file of a submission; empty if it was handed in inside an archive.
std::optional<HandedIn> sourceOf(const std::string& owner,
                                 const std::multimap<std::string, std::string>& names,
                                 const fs::path& download, const Exercise& exercise) {
    const auto [first, last] = names.equal_range(owner);
    const intake::Contents contents = intake::readArchive(download, {.exercise = &exercise}, owner);
    for (auto name = first; name != last; ++name)
        for (const intake::Candidate& candidate : contents.candidates) {
            const bool isThis = intake::readCanvasName(name->second)->file == candidate.path;
            if (isThis && candidate.part.ends_with(".cpp") && !candidate.refusal)
                return HandedIn{name->second, candidate.bytes};
        }
    return std::nullopt;
}

void writeComments(const std::vector<report::StudentView>& views,
                   const std::vector<std::size_t>& graded, const fs::path& download,
                   const fs::path& file) {
    const std::multimap<std::string, std::string> names = namesByOwner(download);
    if (names.empty())
        throw raytracer::InputError(download.string(), 0,
                                    "expected the zip of Canvas's \"Download Submissions\"");
    zip::ZipWriter zip{file};
    for (const std::size_t index : graded) {
        const std::string& submission = views[index].result().submission;
        if (const auto source = sourceOf(submission, names, download, views[index].exercise()))
            zip.add(source->name, report::commentedSource(views[index], source->bytes));
        else
            fmt::print(stderr,
                       "{}: no comment, since no .cpp file was handed in outside an archive\n",
                       submission);
    }
    zip.finish();
}

}  // namespace

std::vector<fs::path> writeCanvas(const fs::path& out,
                                  const std::vector<report::StudentView>& views,
                                  const FormatOptions& options) {
    if (options.worksheet.empty())
        throw raytracer::InputError("--format canvas", 0,
                                    "needs --worksheet FILE: the gradebook that Canvas exported");
    const report::CanvasGrades grades = report::fillCanvasGradebook(
        readWhole(options.worksheet, "cannot be read; expected the gradebook of Canvas"),
        options.worksheet, options.assignment, views);
    std::vector<fs::path> written{out / "canvas-gradebook.csv"};
    writeAtomically(grades.gradebook, written.front());
    if (!options.download.empty()) {
        written.push_back(out / "canvas-comments.zip");
        writeComments(views, grades.graded, options.download, written.back());
    }
    for (const std::string& remark : grades.remarks)
        fmt::print(stderr, "{}\n", remark);
    fmt::print(stderr,
               "{} graded. Import the gradebook, and look at the changes that Canvas shows before "
               "you confirm them.\n",
               grades.graded.size());
    return written;
}

}  // namespace ticker::cli
