#ifndef TICKER_SANDBOX_RUNAT_H
#define TICKER_SANDBOX_RUNAT_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/StagingFolder.h>

namespace ticker::sandbox {

/// Runs the command at a level, without first checking that the level works.
[[nodiscard]] Outcome runAt(Level level, const Command& command);

/// Runs a program that does nothing: the trial run of a level.
[[nodiscard]] Outcome runNothing(Level level);

/// The staging folder of this process.
[[nodiscard]] const StagingFolder& staging();

}  // namespace ticker::sandbox

#endif
