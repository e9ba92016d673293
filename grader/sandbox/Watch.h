#ifndef TICKER_SANDBOX_WATCH_H
#define TICKER_SANDBOX_WATCH_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/Spawner.h>

namespace ticker::sandbox {

/// Starts the helper as `launch` says, with an empty stdin, and collects stdout and stderr. Waits
/// until the command ends or reaches a limit, and says how it ended. On return none of its
/// processes runs.
[[nodiscard]] Outcome watch(Launch launch, const Limits& limits);

}  // namespace ticker::sandbox

#endif
