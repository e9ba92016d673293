#ifndef TICKER_SANDBOX_SPAWNER_H
#define TICKER_SANDBOX_SPAWNER_H

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// Descriptor `host` of this process becomes `target` in the child.
struct Redirection {
    int host = -1;
    int target = -1;
};

/// A program to start. All descriptors without a redirection are closed.
struct Launch {
    std::filesystem::path program;
    std::vector<std::string> arguments;  ///< without argv[0]
    std::vector<Redirection> redirections;
};

struct Launched {
    pid_t pid = -1;
    int error = 0;  ///< errno where pid is -1
};

/// Starts the program from a thread that lives as long as the process: a child with a parent-death
/// signal dies when the *thread* that made it ends. Safe to call from any thread.
[[nodiscard]] Launched launch(const Launch& launch);

}  // namespace ticker::sandbox

#endif
