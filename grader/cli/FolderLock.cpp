#include <grader/cli/FolderLock.h>

#include <raytracer/base/Error.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// ".summary.csv.123.part": process 123 was killed while writing (see writeAtomically).
bool isLeftOver(const std::string& name) {
    const std::string ending = ".part";
    if (!name.starts_with('.') || !name.ends_with(ending)) return false;
    const std::string rest = name.substr(0, name.size() - ending.size());
    const int process = std::atoi(rest.substr(rest.rfind('.') + 1).c_str());
    return process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
}

void removeLeftOvers(const fs::path& folder) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, error})
        if (isLeftOver(entry.path().filename().string())) fs::remove(entry.path(), error);
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(open((folder / ".ticker-lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_.get() >= 0 && flock(file_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw raytracer::InputError(
            folder.string(), 0,
            "another ticker is grading into it; let it finish, or give another folder with -o");
    removeLeftOvers(folder);
    // Pages are also written into the folders of submissions that are not graded again.
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, error})
        if (!entry.is_symlink() && entry.is_directory()) removeLeftOvers(entry.path());
}

}  // namespace ticker::cli
