#ifndef TICKER_SANDBOX_SHAREDMEMORY_H
#define TICKER_SANDBOX_SHAREDMEMORY_H

#include <grader/base/FileDescriptor.h>

#include <cstddef>
#include <span>

namespace ticker::sandbox {

/// An anonymous memory file (memfd) of fixed size that can be passed to another process.
class SharedMemory {
public:
    /// Zero bytes, sealed against growing and shrinking.
    /// @throws raytracer::Error (notGradable) if the system provides none.
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

/// A memory file with these bytes, sealed against every change.
[[nodiscard]] FileDescriptor sealedCopy(std::span<const std::byte> bytes);

}  // namespace ticker::sandbox

#endif
