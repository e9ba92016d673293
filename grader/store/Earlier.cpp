#include <grader/store/Earlier.h>

#include <grader/result/ResultJson.h>
#include <grader/result/Tally.h>
#include <grader/store/ClassFolder.h>

#include <raytracer/base/Error.h>

#include <fmt/chrono.h>
#include <fmt/core.h>

#include <sys/stat.h>

#include <system_error>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEarlier = "earlier";

/// The first number without a folder; from 1.
int nextNumber(const fs::path& folder) {
    std::error_code ignored;
    int number = 1;
    while (fs::exists(folder / std::to_string(number), ignored))
        ++number;
    return number;
}

raytracer::InputError cannotMove(const fs::path& what, const fs::path& folder,
                                 const std::error_code& error) {
    return {what.string(), 0,
            fmt::format("the earlier hand-in cannot be moved to {}: {}. It stays as it was, and "
                        "nothing new is written; make room or rights, then grade with --resume",
                        folder.string(), error.message())};
}

/// Moves both or nothing: what stays behind would be replaced.
void moveTo(const fs::path& folder, const fs::path& submission) {
    std::error_code error;
    std::error_code ignored;
    fs::create_directories(folder, error);
    if (error) throw cannotMove(submission, folder, error);
    fs::rename(submission / "result.json", folder / "result.json", error);
    if (error) {
        fs::remove(folder, ignored);
        throw cannotMove(submission / "result.json", folder, error);
    }
    fs::rename(submission / "code", folder / "code", error);
    if (!error || error == std::errc::no_such_file_or_directory) return;
    fs::rename(folder / "result.json", submission / "result.json", ignored);
    fs::remove(folder, ignored);
    throw cannotMove(submission / "code", folder, error);
}

std::string changedAt(const fs::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return "";
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(status.st_mtime));
}

}  // namespace

void keepEarlier(const fs::path& out, const SubmissionResult& next) {
    const auto before = readWholeResult(out, next.submission);
    if (!before || before->verdict == Verdict::notGraded) return;
    if (before->inputs.files == next.inputs.files && before->verdict == next.verdict &&
        findingIds(*before) == findingIds(next))
        return;
    const fs::path all = out / next.submission / kEarlier;
    moveTo(all / std::to_string(nextNumber(all)), out / next.submission);
}

std::vector<Earlier> earlierResults(const fs::path& out, const std::string& submission) {
    const fs::path all = out / submission / kEarlier;
    std::vector<Earlier> earlier;
    for (int number = nextNumber(all) - 1; number > 0; --number) {
        const fs::path folder = all / std::to_string(number);
        try {
            earlier.push_back({readResultJson(folder / "result.json"), folder / "code",
                               changedAt(folder / "result.json")});
        } catch (const raytracer::InputError&) {
            continue;  // a grading was killed while it moved the files
        }
    }
    return earlier;
}

}  // namespace ticker::store
