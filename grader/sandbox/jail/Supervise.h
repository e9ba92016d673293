#ifndef TICKER_SANDBOX_JAIL_SUPERVISE_H
#define TICKER_SANDBOX_JAIL_SUPERVISE_H

#include <grader/sandbox/jail/Options.h>
#include <grader/sandbox/jail/Report.h>

namespace ticker::jail {

/// Starts the command, waits for its end or for SIGTERM, ends and reaps everything that descends
/// from it, and copies its products. The calling process must have no other children.
[[nodiscard]] Report supervise(const Options& options);

}  // namespace ticker::jail

#endif
