#ifndef TICKER_SANDBOX_SHAREDMEMORY_H
#define TICKER_SANDBOX_SHAREDMEMORY_H

#include <grader/base/FileDescriptor.h>

#include <cstddef>
#include <span>

namespace ticker::sandbox {

/// A memory file of fixed size that can be handed to another process. It has no name.
class SharedMemory {
public:
    /// Zero bytes; sealed, so that nobody can make it longer or shorter.
    /// @throws raytracer::Error (notGradable) where the system gives none.
    explicit SharedMemory(std::size_t size);
    ~SharedMemory();
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;

    [[nodiscard]] std::span<std::byte> bytes() const { return bytes_; }
    [[nodiscard]] int descriptor() const { return descriptor_.get(); }

private:
    FileDescriptor descriptor_;
    std::span<std::byte> bytes_;
};

/// A memory file that nobody can change any more.
[[nodiscard]] FileDescriptor sealedCopy(std::span<const std::byte> bytes);

}  // namespace ticker::sandbox

#endif
