#ifndef TICKER_SANDBOX_WATCH_H
#define TICKER_SANDBOX_WATCH_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/Spawner.h>

namespace ticker::sandbox {

/// Starts the helper as `launch` says, with stdin empty and stdout and stderr read by us, waits for
/// its end or for the limits, and says how the command ended. On return nothing of it runs.
[[nodiscard]] Outcome watch(Launch launch, const Limits& limits);

}  // namespace ticker::sandbox

#endif
