#ifndef TICKER_SANDBOX_JAIL_START_H
#define TICKER_SANDBOX_JAIL_START_H

#include <grader/sandbox/jail/Options.h>

#include <sys/types.h>

namespace ticker::jail {

/// Exit status of a command that is there, but that the system will not run: as in a shell.
inline constexpr int kNotExecutable = 126;

/// What a child tells about a step that failed before its command began.
struct StartFailure {
    int error = 0;
    char step[40] = {};
};

/// In the child of `parent`: gives up everything that the options take away, then becomes the
/// command. Returns only if that failed; `keepOpen` is there to tell of it.
[[nodiscard]] StartFailure becomeCommand(const Options& options, pid_t parent, int keepOpen);

}  // namespace ticker::jail

#endif
