#include <grader/sandbox/UserSlots.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace ticker::sandbox {
namespace {

// A folder that only root can write: no other user can create or replace a lock.
FileDescriptor openLockFolder() {
    for (const char* path : {"/run/ticker", "/var/tmp/ticker-locks"}) {
        mkdir(path, 0700);
        FileDescriptor folder{open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)};
        struct stat status {};
        if (folder.isOpen() && fstat(folder.get(), &status) == 0 && status.st_uid == geteuid() &&
            (status.st_mode & (S_IWGRP | S_IWOTH)) == 0)
            return folder;
    }
    throw raytracer::Error(
        "sandbox: neither /run/ticker nor /var/tmp/ticker-locks can be made; "
        "one is needed to share uids among processes");
}

// Reserves a free uid of the range; empty if all are in use.
std::optional<UserSlot> freeSlot(const FileDescriptor& folder, const UserRange& range) {
    for (long user = range.first; user < range.first + range.count; ++user) {
        const std::string name = fmt::format("uid-{}", user);
        FileDescriptor lock{
            openat(folder.get(), name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600)};
        if (!lock.isOpen())
            throw raytracer::Error(fmt::format("sandbox: cannot open the lock {}: {}", name,
                                               std::generic_category().message(errno)));
        if (flock(lock.get(), LOCK_EX | LOCK_NB) == 0) return UserSlot{user, std::move(lock)};
    }
    return std::nullopt;
}

}  // namespace

// A file lock of another process gives no signal when it is released, so this tries repeatedly.
UserSlot takeUserSlot(const UserRange& range, std::chrono::milliseconds patience) {
    if (geteuid() != 0) return {};
    constexpr std::chrono::milliseconds kPause{10};
    const FileDescriptor folder = openLockFolder();
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        if (std::optional<UserSlot> slot = freeSlot(folder, range)) return std::move(*slot);
        if (std::chrono::steady_clock::now() >= end) break;
        std::this_thread::sleep_for(kPause);
    }
    throw raytracer::Error(
        fmt::format("sandbox: all {} uids from {} on are in use: fewer jobs at once, or a larger "
                    "range in grader/sandbox/limits.json, and build again",
                    range.count, range.first));
}

}  // namespace ticker::sandbox
