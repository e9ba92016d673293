#ifndef TICKER_SANDBOX_SHAREDMEMORY_H
#define TICKER_SANDBOX_SHAREDMEMORY_H

#include <grader/base/FileDescriptor.h>

#include <cstddef>
#include <span>

namespace ticker::sandbox {

/// An anonymous memory file (memfd) of fixed size that can be passed to another process. It is not
/// mapped here: what is read is a copy that the other process cannot change.
class SharedMemory {
public:
    /// Zero bytes, sealed against growing and shrinking.
    /// @throws raytracer::Error (notGradable) if the system provides none.
    explicit SharedMemory(std::size_t size);

    /// Bytes from `at` on; all of them lie inside.
    /// @throws raytracer::Error (notGradable) if the system has no memory left.
    void write(std::size_t at, std::span<const std::byte> bytes) const;
    void read(std::size_t at, std::span<std::byte> bytes) const;

    [[nodiscard]] int descriptor() const { return descriptor_.get(); }

private:
    FileDescriptor descriptor_;
};

/// A memory file with these bytes, sealed against every change.
[[nodiscard]] FileDescriptor sealedCopy(std::span<const std::byte> bytes);

}  // namespace ticker::sandbox

#endif
