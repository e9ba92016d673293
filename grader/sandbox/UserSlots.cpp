#include <grader/sandbox/UserSlots.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

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

}  // namespace

UserSlot takeUserSlot(const UserRange& range) {
    if (geteuid() != 0) return {};
    const FileDescriptor folder = openLockFolder();
    for (long user = range.first; user < range.first + range.count; ++user) {
        const std::string name = fmt::format("uid-{}", user);
        FileDescriptor lock{
            openat(folder.get(), name.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600)};
        if (lock.isOpen() && flock(lock.get(), LOCK_EX | LOCK_NB) == 0)
            return {user, std::move(lock)};
    }
    throw raytracer::Error(
        fmt::format("sandbox: all {} uids from {} on are in use: fewer jobs at once, or a larger "
                    "range in limits.json",
                    range.count, range.first));
}

}  // namespace ticker::sandbox
