#ifndef TICKER_SANDBOX_JAIL_START_H
#define TICKER_SANDBOX_JAIL_START_H

#include <grader/sandbox/jail/JailOptions.h>

#include <sys/types.h>

namespace ticker::jail {

/// Sent by a child when a step fails before its command begins.
struct StartFailure {
    int error = 0;
    char step[40] = {};
};

/// Called in the child of `parent`: gives up all rights that the options take away, then becomes
/// the command. Returns only on failure, which the caller reports over `keepOpen`.
[[nodiscard]] StartFailure becomeCommand(const Options& options, pid_t parent, int keepOpen);

}  // namespace ticker::jail

#endif
