#ifndef GRADER_TESTS_SCENES_STUDENTPROGRAM_H
#define GRADER_TESTS_SCENES_STUDENTPROGRAM_H

#include <sys/types.h>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::testing {

/// Result of a program.
struct ProgramResult {
    int exitCode = -1;  ///< -1 where a signal ended it
    std::string out;
    std::string err;
};

/// Runs tick1star and waits for it.
/// @param solution  "reference" or "template".
[[nodiscard]] ProgramResult runTick1Star(const std::vector<std::string>& arguments,
                                         const std::filesystem::path& scratch,
                                         const std::string& solution = "reference");

/// tick1star with the reference solution in a terminal of its own: Ctrl-C typed there reaches it.
class Tick1StarOnTerminal {
public:
    /// @param environment  "NAME=value", before the existing variables; "NAME=" unsets a variable
    ///                     in effect.
    Tick1StarOnTerminal(std::vector<std::string> arguments, std::vector<std::string> environment,
                        int columns = 80, int lines = 24);
    ~Tick1StarOnTerminal();
    Tick1StarOnTerminal(const Tick1StarOnTerminal&) = delete;
    Tick1StarOnTerminal& operator=(const Tick1StarOnTerminal&) = delete;

    /// Waits for the program's next output; empty at its end.
    [[nodiscard]] std::string read() const;
    /// Everything up to the program's end.
    [[nodiscard]] std::string readAll() const;
    /// Types Ctrl-C.
    void interrupt() const;
    /// The exit code; -1 where a signal ended it.
    [[nodiscard]] int wait();

private:
    int terminal_ = -1;
    pid_t process_ = -1;
};

}  // namespace ticker::testing

#endif
