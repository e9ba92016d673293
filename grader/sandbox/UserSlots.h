#ifndef TICKER_SANDBOX_USERSLOTS_H
#define TICKER_SANDBOX_USERSLOTS_H

#include <grader/base/FileDescriptor.h>

#include <string>

namespace ticker::sandbox {

/// The uids that jails get where we are root: one for each jail at a time, on the whole machine.
struct UserRange {
    long first = 0;
    int count = 0;
};

/// A uid that nobody else uses while this lives; -1 where we are not root and keep our own.
class UserSlot {
public:
    UserSlot() = default;
    UserSlot(long user, FileDescriptor lock) : user_(user), lock_(std::move(lock)) {}
    [[nodiscard]] long user() const { return user_; }

private:
    long user_ = -1;
    FileDescriptor lock_;
};

/// Takes a free uid of the range.
/// @throws raytracer::Error where none is free, or locks cannot be had.
[[nodiscard]] UserSlot takeUserSlot(const UserRange& range);

}  // namespace ticker::sandbox

#endif
