#ifndef TICKER_CLI_PROGRESSLINE_H
#define TICKER_CLI_PROGRESSLINE_H

#include <grader/result/SubmissionResult.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace ticker::cli {

/// True if stderr is a terminal, NO_COLOR is not set and quiet is off.
[[nodiscard]] bool mayDraw(bool quiet);

/// What draws `text` over the last line of a terminal of so many columns. It is cut, since what
/// wraps stays on the screen when the line is drawn anew.
/// @param text     Of ASCII.
/// @param columns  0: not known; nothing is cut.
[[nodiscard]] std::string drawnLine(std::string_view text, std::size_t columns);

/// A progress line of a class on stderr: bar, rate, time left, counts. Threads may share it. Draws
/// nothing if drawing is off.
class Progress {
public:
    Progress(std::size_t total, bool draw);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Counts one finished submission.
    /// @param isKept  It had a result before, so that it does not count for the rate.
    void finished(Verdict verdict, bool isKept = false);

    /// Prints one line on stdout, above the bar.
    void print(const std::string& line);

private:
    void drawLine() const;

    std::size_t total_;
    bool draw_;
    std::chrono::steady_clock::time_point start_;
    mutable std::mutex mutex_;
    std::size_t done_ = 0;
    std::size_t kept_ = 0;
    std::map<Verdict, std::size_t> counts_;
};

/// A progress line on stderr for other work: the amount done and the time left.
class Countdown {
public:
    /// @param already  Work done before, which does not count for the rate.
    Countdown(std::string what, std::size_t already, bool draw);
    ~Countdown();
    Countdown(const Countdown&) = delete;
    Countdown& operator=(const Countdown&) = delete;

    void show(std::size_t done, std::size_t of) const;

private:
    std::string what_;
    std::size_t already_;
    bool draw_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace ticker::cli

#endif
