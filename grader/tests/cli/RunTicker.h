#ifndef TICKER_TESTS_CLI_RUNTICKER_H
#define TICKER_TESTS_CLI_RUNTICKER_H

#include <sys/wait.h>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

namespace ticker::cli {

/// Result of a run of `ticker`.
struct Ran {
    int status = -1;
    std::string output;  ///< stdout
    std::string errors;  ///< stderr
};

/// Runs the program `ticker` of the build folder, or another one, through a shell.
/// @param arguments   As typed in a shell.
/// @param errorsFile  A file of the test's own, which receives stderr.
inline Ran runTicker(const std::string& arguments, const std::string& errorsFile,
                     const std::string& program = "ticker") {
    const std::string command = std::string{TICKER_BINARY_DIR} + "/bin/" + program + " " +
                                arguments + " 2>'" + errorsFile + "'";
    std::FILE* const pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
    Ran ran;
    std::array<char, 4096> buffer{};
    for (std::size_t got = 0; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        ran.output.append(buffer.data(), got);
    const int status = ::pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    std::ifstream errors{errorsFile};
    ran.errors.assign(std::istreambuf_iterator<char>{errors}, {});
    return ran;
}

}  // namespace ticker::cli

#endif
