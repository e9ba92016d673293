#ifndef TICKER_SANDBOX_JAIL_LOCKDOWN_H
#define TICKER_SANDBOX_JAIL_LOCKDOWN_H

#include <grader/sandbox/jail/JailOptions.h>

namespace ticker::jail {

/// Name of the step that failed, with errno set; nullptr if all steps succeeded.
using Failure = const char*;

/// Sets the rlimits of the calling process.
[[nodiscard]] Failure limitResources(const Options& options);

/// Landlock: from now on only the folders that `options` names can be accessed.
[[nodiscard]] Failure restrictFiles(const Options& options);

/// seccomp: from now on only the system calls of the filter are allowed, plus one execve.
[[nodiscard]] Failure restrictSystemCalls(Filter filter);

}  // namespace ticker::jail

#endif
