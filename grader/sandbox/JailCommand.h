#ifndef TICKER_SANDBOX_JAILCOMMAND_H
#define TICKER_SANDBOX_JAILCOMMAND_H

#include <grader/sandbox/Sandbox.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// Resources that belong to one run.
struct JailPlace {
    Level level = Level::none;
    bool landlock = false;  ///< the kernel supports Landlock
    bool countsProcesses =
        false;  ///< the kernel counts processes in each user namespace separately
    std::filesystem::path helper;      ///< readable by the jail's user
    std::filesystem::path bubblewrap;  ///< level A only
    long user = -1;                    ///< uid to become; -1: the caller's own
    std::filesystem::path scratch;     ///< host folder; empty at level A and where none is wanted
};

/// The helper's arguments that run `command` in the jail.
[[nodiscard]] std::vector<std::string> jailArguments(const Command& command,
                                                     const JailPlace& place);

}  // namespace ticker::sandbox

#endif
