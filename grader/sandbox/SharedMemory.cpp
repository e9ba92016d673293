#include <grader/sandbox/SharedMemory.h>

#include <raytracer/base/Error.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace ticker::sandbox {
namespace {

void require(bool done, const char* what) {
    if (!done)
        throw raytracer::Error(std::string{"cannot "} + what +
                               " a memory file: " + std::generic_category().message(errno));
}

FileDescriptor memoryFile() {
    FileDescriptor file{memfd_create("ticker", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
    require(file.isOpen(), "make");
    return file;
}

// EBUSY: the kernel itself holds a page for a moment, as when it moves memory. It waits for 0.15 s
// in each call, which is too short on a busy machine.
bool seal(const FileDescriptor& file, int seals) {
    constexpr int kMostTries = 40;
    for (int i = 0; i < kMostTries; ++i) {
        if (fcntl(file.get(), F_ADD_SEALS, seals) == 0) return true;
        if (errno != EBUSY) return false;
    }
    return false;
}

}  // namespace

SharedMemory::SharedMemory(std::size_t size) : descriptor_(memoryFile()) {
    require(ftruncate(descriptor_.get(), static_cast<off_t>(size)) == 0, "size");
    require(seal(descriptor_, F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL), "seal");
}

void SharedMemory::write(std::size_t at, std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t written =
            pwrite(descriptor_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
        require(written > 0, "write");
        at += static_cast<std::size_t>(written);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void SharedMemory::read(std::size_t at, std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count =
            pread(descriptor_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
        require(count > 0, "read");
        at += static_cast<std::size_t>(count);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

FileDescriptor sealedCopy(std::span<const std::byte> bytes) {
    FileDescriptor file = memoryFile();
    while (!bytes.empty()) {
        const ssize_t written = write(file.get(), bytes.data(), bytes.size());
        require(written > 0, "fill");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    require(seal(file, F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL), "seal");
    return file;
}

}  // namespace ticker::sandbox
