#ifndef TICKER_BUILD_TIMEBUDGET_H
#define TICKER_BUILD_TIMEBUDGET_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <chrono>
#include <mutex>
#include <vector>

namespace ticker::build {

/// Time limit of all runs of one submission together; each run also has its own limits. The wall
/// clock counts while any run lasts, so that parallel runs, which slow each other down, cost no
/// more than one after the other. Safe to share between threads; parallel runs may exceed the
/// budget by the limits of one run.
class TimeBudget {
public:
    using Clock = std::chrono::steady_clock;

    explicit TimeBudget(const sandbox::TimeLimits& all) : all_(all) {}

    /// True if no time is left for another run.
    [[nodiscard]] bool isSpent() const;
    /// The limits of one run, reduced to the rest of the budget.
    [[nodiscard]] sandbox::Limits cut(sandbox::Limits limits) const;
    /// Takes a run's time off.
    /// @param ended  When the run ended.
    void spend(const sandbox::Outcome& outcome, Clock::time_point ended = Clock::now());

    /// Limits of all runs together.
    [[nodiscard]] const sandbox::TimeLimits& all() const { return all_; }

private:
    /// A time in which at least one run lasted.
    struct Span {
        Clock::time_point begin;
        Clock::time_point end;
    };

    /// What is left. The caller holds the mutex.
    [[nodiscard]] sandbox::TimeLimits rest() const;

    sandbox::TimeLimits all_;
    mutable std::mutex mutex_;
    double cpuSeconds_ = 0.0;
    std::vector<Span> spans_;  ///< of runs that have ended; they do not overlap
};

}  // namespace ticker::build

#endif
