#ifndef TICKER_TESTS_SUPPORT_ASNOBODY_H
#define TICKER_TESTS_SUPPORT_ASNOBODY_H

#include <unistd.h>

#include <stdexcept>

namespace ticker::tests {

/// Root may read everything. As long as this object lives, root is a user who may not.
class AsNobody {
public:
    AsNobody() {
        constexpr uid_t kNobody = 65534;
        if (isRoot_ && seteuid(kNobody) != 0) throw std::runtime_error("cannot become nobody");
    }
    ~AsNobody() {
        if (isRoot_ && seteuid(0) != 0) _exit(1);
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

private:
    bool isRoot_ = geteuid() == 0;
};

}  // namespace ticker::tests

#endif
