#ifndef GRADER_TESTS_SCENES_PROGRAM_H
#define GRADER_TESTS_SCENES_PROGRAM_H

#include <sys/types.h>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::testing {

/// What a program left behind.
struct ProgramResult {
    int exitCode = -1;  ///< -1 where a signal ended it
    std::string out;
    std::string err;
};

/// Runs tick1star with the reference solution and waits for it.
[[nodiscard]] ProgramResult runTick1Star(const std::vector<std::string>& arguments,
                                         const std::filesystem::path& scratch);

/// tick1star with the reference solution, its stderr on a terminal of its own.
class Tick1StarOnTerminal {
public:
    Tick1StarOnTerminal(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& extraEnvironment);
    ~Tick1StarOnTerminal();
    Tick1StarOnTerminal(const Tick1StarOnTerminal&) = delete;
    Tick1StarOnTerminal& operator=(const Tick1StarOnTerminal&) = delete;

    /// Waits for what the program writes next; empty at its end.
    [[nodiscard]] std::string read() const;
    /// As Ctrl-C does.
    void interrupt() const;
    /// The exit code; -1 where a signal ended it.
    [[nodiscard]] int wait();

private:
    int terminal_;
    pid_t process_;
};

}  // namespace ticker::testing

#endif
