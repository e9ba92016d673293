#ifndef TICKER_SANDBOX_JAIL_LOCKDOWN_H
#define TICKER_SANDBOX_JAIL_LOCKDOWN_H

#include <grader/sandbox/jail/Options.h>

namespace ticker::jail {

/// Name of the step that failed, with errno set; nullptr if all went well.
using Failure = const char*;

/// rlimits of the calling process.
[[nodiscard]] Failure limitResources(const Options& options);

/// Landlock: only the folders that `options` names can be reached from now on.
[[nodiscard]] Failure restrictFiles(const Options& options);

/// seccomp: only the system calls of the filter from now on, plus one execve.
[[nodiscard]] Failure restrictSystemCalls(Filter filter);

}  // namespace ticker::jail

#endif
