#include <grader/cli/FolderLock.h>

#include <raytracer/base/Error.h>

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>

namespace ticker::cli {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(open((folder / ".ticker-lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (file_.get() >= 0 && flock(file_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw raytracer::InputError(
            folder.string(), 0,
            "another ticker is grading into it; let it finish, or give another folder with -o");
}

}  // namespace ticker::cli
