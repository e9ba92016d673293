#ifndef TICKER_CLI_PROGRESS_H
#define TICKER_CLI_PROGRESS_H

#include <grader/result/SubmissionResult.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace ticker::cli {

/// True where stderr is a terminal, NO_COLOR is not set and nobody asked for quiet.
[[nodiscard]] bool mayDraw(bool quiet);

/// A line on stderr that says how far a class is: bar, rate, time left, running counts.
/// May be shared by threads. Draws nothing where it may not.
class Progress {
public:
    Progress(std::size_t total, bool draw);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more submission is finished.
    /// @param isKept  It had a result before: that took no time and says nothing about the rate.
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

/// One line on stderr for work of another kind: how much is done and how long the rest will take.
class Countdown {
public:
    /// @param already  What was done before and says nothing about the speed.
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
