#ifndef TICKER_TESTS_PACKAGE_CLEANROOT_H
#define TICKER_TESTS_PACKAGE_CLEANROOT_H

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ticker::tests {

/// Result of a command in a clean root.
struct RootRun {
    int status = -1;
    std::string output;  ///< stdout
    std::string errors;  ///< stderr
};

/// A root of this system's /usr and folders that a test names: no checkout, no home, no network, no
/// environment.
class CleanRoot {
public:
    /// @param host  A folder or file of this machine. @param inside  Where commands see it.
    CleanRoot& bind(const std::filesystem::path& host, const std::string& inside);
    CleanRoot& bindReadOnly(const std::filesystem::path& host, const std::string& inside);
    CleanRoot& set(const std::string& variable, const std::string& value);

    /// Adds the files of /etc that libraries outside /usr/lib need, as on an ordinary system.
    /// Without them OpenCV does not find its own libraries.
    CleanRoot& withSystemLibraries();

    /// Runs a command as root of a container like Docker's: no namespaces, few capabilities. As an
    /// ordinary user, runs it as that user.
    [[nodiscard]] RootRun runInContainer(const std::string& command) const;
    [[nodiscard]] RootRun run(const std::string& command) const;

private:
    [[nodiscard]] RootRun runShell(const std::string& inside) const;

    std::vector<std::string> words_;
};

/// Runs a shell command of this machine.
[[nodiscard]] RootRun runHere(const std::string& command);

/// The text of a file; empty if the file does not exist.
[[nodiscard]] std::string textOf(const std::filesystem::path& file);

}  // namespace ticker::tests

#endif
