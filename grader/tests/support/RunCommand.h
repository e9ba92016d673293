#ifndef TICKER_TESTS_SUPPORT_RUNCOMMAND_H
#define TICKER_TESTS_SUPPORT_RUNCOMMAND_H

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace ticker::tests {

/// Output of a command, stdout and stderr together, and its exit status.
struct CommandResult {
    int status = -1;  ///< 128 where a signal ended it
    std::string output;
};

/// Runs a shell command.
[[nodiscard]] inline CommandResult runCommand(const std::string& command) {
    std::FILE* const pipe = ::popen(("{ " + command + "\n} 2>&1").c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
    CommandResult result;
    std::array<char, 4096> buffer{};
    for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        result.output.append(buffer.data(), got);
    const int status = ::pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return result;
}

}  // namespace ticker::tests

#endif
