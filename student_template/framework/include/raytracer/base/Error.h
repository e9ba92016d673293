#ifndef RAYTRACER_BASE_ERROR_H
#define RAYTRACER_BASE_ERROR_H

#include <stdexcept>
#include <string>

namespace raytracer {

/// Exit status of a program. The numbers are fixed: scripts rely on them.
enum class ExitCode : int {
    success = 0,
    checkFailed = 1,   ///< a check did not pass
    badInput = 2,      ///< wrong usage, or an input that cannot be read
    notGradable = 3,   ///< an error of the program or the system, not of the user
    interrupted = 130  ///< stopped by Ctrl-C
};

/// The number for `exit`.
[[nodiscard]] constexpr int toInt(ExitCode code) {
    return static_cast<int>(code);
}

/// Base of every error that the kit throws. `main` turns it into a message and an exit code; work
/// that goes through many files or submissions catches it for each of them, so that one failure
/// does not end the others.
class Error : public std::runtime_error {
public:
    /// @param message   One line that says what went wrong, where, and what to do next.
    /// @param exitCode  The status that `main` returns.
    explicit Error(const std::string& message, ExitCode exitCode = ExitCode::notGradable)
        : std::runtime_error(message), exitCode_(exitCode) {}

    [[nodiscard]] ExitCode exitCode() const { return exitCode_; }

private:
    ExitCode exitCode_;
};

/// An input that cannot be used. Its message starts with "file:line: " (or "file: ").
class InputError : public Error {
public:
    /// @param file     Path as the user gave it; may be empty for wrong usage.
    /// @param line     Line in the file, counted from 1; 0 if the format has no lines.
    /// @param message  What was found and what was expected.
    InputError(const std::string& file, int line, const std::string& message)
        : Error(locate(file, line) + message, ExitCode::badInput), file_(file), line_(line) {}

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] int line() const { return line_; }

private:
    static std::string locate(const std::string& file, int line) {
        if (file.empty()) return {};
        return line > 0 ? file + ":" + std::to_string(line) + ": " : file + ": ";
    }

    std::string file_;
    int line_;
};

}  // namespace raytracer

#endif
