#ifndef TICKER_SANDBOX_JAIL_SUPERVISE_H
#define TICKER_SANDBOX_JAIL_SUPERVISE_H

#include <grader/sandbox/jail/JailOptions.h>
#include <grader/sandbox/jail/Report.h>

namespace ticker::jail {

/// Starts the command and waits until it ends or SIGTERM arrives. Then ends and reaps all its
/// descendants, and copies its products. The calling process must have no other children.
[[nodiscard]] Report supervise(const Options& options);

}  // namespace ticker::jail

#endif
