#include <grader/store/Earlier.h>

#include <grader/base/UtcText.h>
#include <grader/result/ResultJson.h>
#include <grader/result/Tally.h>
#include <grader/store/ClassFolder.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <sys/stat.h>

#include <system_error>

namespace ticker::store {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEarlier = "earlier";
constexpr const char* kUnfinished = ".new";  ///< in "earlier", while the files are moved

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

/// The files of `submission` go to earlier/.new, the code first, which then gets its number: a kill
/// between two steps leaves what `finish` can complete.
void moveFrom(const fs::path& submission) {
    const fs::path all = submission / kEarlier;
    const fs::path target = all / std::to_string(nextNumber(all));
    const fs::path moved = all / kUnfinished;
    std::error_code error;
    std::error_code ignored;
    fs::create_directories(moved, error);
    if (error) throw cannotMove(submission, target, error);
    fs::rename(submission / "code", moved / "code", error);
    if (error && error != std::errc::no_such_file_or_directory) {
        fs::remove(moved, ignored);
        throw cannotMove(submission / "code", target, error);
    }
    fs::rename(submission / "result.json", moved / "result.json", error);
    if (error) {
        fs::rename(moved / "code", submission / "code", ignored);
        fs::remove(moved, ignored);
        throw cannotMove(submission / "result.json", target, error);
    }
    fs::rename(moved, target, error);
    if (error) throw cannotMove(moved, target, error);
}

/// Completes a move that a kill has interrupted. Code whose result has not moved goes back to it.
void finish(const fs::path& submission) {
    const fs::path all = submission / kEarlier;
    const fs::path moved = all / kUnfinished;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(moved, error))) return;
    if (!fs::exists(moved / "result.json", error)) {
        fs::rename(moved / "code", submission / "code", error);
        if (fs::remove(moved, error)) return;
    }
    const fs::path target = all / std::to_string(nextNumber(all));
    fs::rename(moved, target, error);
    if (error) throw cannotMove(moved, target, error);
}

bool agree(const SubmissionResult& one, const SubmissionResult& other) {
    return one.inputs.files == other.inputs.files && one.verdict == other.verdict &&
           findingIds(one) == findingIds(other);
}

/// Removes the newest earlier result if it agrees with `next`: only a fault of the machine came
/// between the two, so that it is no earlier hand-in.
void dropNewestLike(const SubmissionResult& next, const fs::path& all) {
    const fs::path newest = all / std::to_string(nextNumber(all) - 1);
    std::error_code ignored;
    try {
        if (agree(readResultJson(newest / "result.json"), next)) fs::remove_all(newest, ignored);
    } catch (const raytracer::InputError&) {
        return;  // no earlier result exists, or a kill left its folder without result.json
    }
}

std::string changedAt(const fs::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return "";
    return utcText(status.st_mtime);
}

}  // namespace

bool keepsBefore(const fs::path& out, const SubmissionResult& next) {
    if (next.verdict != Verdict::notGraded || !next.inputs.areKnown()) return false;
    const auto before = readWholeResult(out, next.submission);
    return before && before->verdict != Verdict::notGraded &&
           before->inputs.files == next.inputs.files;
}

void keepEarlier(const fs::path& out, const SubmissionResult& next) {
    finish(out / next.submission);
    const auto before = readWholeResult(out, next.submission);
    if (!before) return;
    if (before->verdict == Verdict::notGraded)
        dropNewestLike(next, out / next.submission / kEarlier);
    else if (!agree(*before, next))
        moveFrom(out / next.submission);
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
