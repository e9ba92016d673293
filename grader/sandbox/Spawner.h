#ifndef TICKER_SANDBOX_SPAWNER_H
#define TICKER_SANDBOX_SPAWNER_H

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// `host` becomes `target` in the child.
struct Redirection {
    int host = -1;
    int target = -1;
};

/// A program to start. Every descriptor that no redirection names is closed.
struct Launch {
    std::filesystem::path program;
    std::vector<std::string> arguments;  ///< without argv[0]
    std::vector<Redirection> redirections;
};

struct Launched {
    pid_t pid = -1;
    int error = 0;  ///< errno where pid is -1
};

/// Starts the program from a thread that lives as long as the process, since children that die with
/// their parent die with the thread that made them. May be called by any thread.
[[nodiscard]] Launched launch(const Launch& launch);

}  // namespace ticker::sandbox

#endif
