#include <grader/sandbox/DiskRoom.h>

#include <sys/statvfs.h>

namespace ticker::sandbox {

// Bytes that running jobs have written count twice, as used and as reserved. That is conservative:
// those jobs may still write the rest of their share.
std::optional<DiskRoom::Share> DiskRoom::take(std::uint64_t bytes) {
    std::unique_lock lock{mutex_};
    while (freeBytes_() < taken_ + bytes) {
        if (taken_ == 0) return std::nullopt;
        changed_.wait(lock);
    }
    taken_ += bytes;
    return std::optional<Share>{std::in_place, *this, bytes};
}

void DiskRoom::giveBack(std::uint64_t bytes) {
    {
        const std::lock_guard lock{mutex_};
        taken_ -= bytes;
    }
    changed_.notify_all();
}

std::uint64_t freeBytesOf(const std::filesystem::path& folder) {
    struct statvfs status {};
    if (statvfs(folder.c_str(), &status) != 0) return 0;
    return static_cast<std::uint64_t>(status.f_bavail) * status.f_frsize;
}

}  // namespace ticker::sandbox
