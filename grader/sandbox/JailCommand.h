#ifndef TICKER_SANDBOX_JAILCOMMAND_H
#define TICKER_SANDBOX_JAILCOMMAND_H

#include <grader/sandbox/Sandbox.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// What one run has to itself.
struct JailPlace {
    Level level = Level::none;
    bool landlock = false;             ///< the kernel has it
    bool countsProcesses = false;      ///< the kernel does so in each user namespace
    std::filesystem::path helper;      ///< readable by the jail's user
    std::filesystem::path bubblewrap;  ///< level A only
    long user = -1;                    ///< uid to become; -1: the caller's own
    std::filesystem::path scratch;     ///< host folder; empty at level A and where none is wanted
};

/// The helper's arguments that lock `command` in.
[[nodiscard]] std::vector<std::string> jailArguments(const Command& command,
                                                     const JailPlace& place);

}  // namespace ticker::sandbox

#endif
