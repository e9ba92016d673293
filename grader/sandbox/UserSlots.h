#ifndef TICKER_SANDBOX_USERSLOTS_H
#define TICKER_SANDBOX_USERSLOTS_H

#include <grader/base/FileDescriptor.h>

#include <chrono>

namespace ticker::sandbox {

/// The uids that jails use when we run as root: one for each jail at a time, on the whole machine.
struct UserRange {
    long first = 0;
    int count = 0;
};

/// A uid that is reserved while this object lives, or a process that inherited its lock; -1 if we
/// are not root and keep our own uid.
class UserSlot {
public:
    UserSlot() = default;
    UserSlot(long user, FileDescriptor lock) : user_(user), lock_(std::move(lock)) {}
    [[nodiscard]] long user() const { return user_; }
    /// The descriptor that holds the reservation, also for a process that inherits it; -1 if none.
    [[nodiscard]] int lock() const { return lock_.get(); }

private:
    long user_ = -1;
    FileDescriptor lock_;
};

/// Reserves a free uid of the range.
/// @param patience  How long to wait while all are in use.
/// @throws raytracer::Error if none became free, or locks are not available.
[[nodiscard]] UserSlot takeUserSlot(const UserRange& range,
                                    std::chrono::milliseconds patience = {});

}  // namespace ticker::sandbox

#endif
