#ifndef TICKER_TESTS_CLI_RUNNINGTICKER_H
#define TICKER_TESTS_CLI_RUNNINGTICKER_H

#include <optional>
#include <string>
#include <vector>

namespace ticker::cli {

/// The program `ticker` of the build folder while it runs, with its stdout at hand and its stderr
/// in a file. Killed at the end of this object, if it still runs.
class RunningTicker {
public:
    RunningTicker(const std::vector<std::string>& arguments, const std::string& errorsFile);
    ~RunningTicker();
    RunningTicker(const RunningTicker&) = delete;
    RunningTicker& operator=(const RunningTicker&) = delete;

    /// The next line of its stdout; empty after its end.
    [[nodiscard]] std::optional<std::string> readLine();
    /// A descriptor that can be read once it prints or ends.
    [[nodiscard]] int output() const { return output_; }

    void send(int signal) const;
    /// Waits for its end: the exit status, or 128 + the signal.
    int wait();

private:
    int process_ = -1;
    int output_ = -1;
    std::string buffer_;
    std::optional<int> status_;
};

}  // namespace ticker::cli

#endif
