#include <grader/intake/OutFolder.h>

#include <grader/intake/Contents.h>

#include <system_error>

namespace ticker::intake {
namespace fs = std::filesystem;

bool holdsResults(const fs::path& folder) {
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(folder / "results.sqlite", error)) ||
           fs::is_regular_file(fs::symlink_status(folder / ".ticker-lock", error));
}

bool isOut(const fs::path& folder, const Wanted& wanted) {
    std::error_code error;
    const bool isGiven = !wanted.out.empty() && fs::equivalent(folder, wanted.out, error);
    if (!isGiven && !holdsResults(folder)) return false;
    fs::directory_iterator entry{folder, error};
    for (; !error && entry != fs::directory_iterator{}; entry.increment(error))
        if (partOf(entry->path().filename().string(), wanted.exercise)) return false;
    return true;
}

}  // namespace ticker::intake
