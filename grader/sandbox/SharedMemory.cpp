#include <grader/sandbox/SharedMemory.h>

#include <raytracer/base/Error.h>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

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

}  // namespace

SharedMemory::SharedMemory(std::size_t size) : descriptor_(memoryFile()) {
    require(ftruncate(descriptor_.get(), static_cast<off_t>(size)) == 0, "size");
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_.get(), 0);
    require(memory != MAP_FAILED, "map");
    bytes_ = {static_cast<std::byte*>(memory), size};
    require(fcntl(descriptor_.get(), F_ADD_SEALS, F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) == 0,
            "seal");
}

SharedMemory::~SharedMemory() {
    munmap(bytes_.data(), bytes_.size());
}

FileDescriptor sealedCopy(std::span<const std::byte> bytes) {
    FileDescriptor file = memoryFile();
    while (!bytes.empty()) {
        const ssize_t written = write(file.get(), bytes.data(), bytes.size());
        require(written > 0, "fill");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    require(fcntl(file.get(), F_ADD_SEALS,
                  F_SEAL_WRITE | F_SEAL_GROW | F_SEAL_SHRINK | F_SEAL_SEAL) == 0,
            "seal");
    return file;
}

}  // namespace ticker::sandbox
