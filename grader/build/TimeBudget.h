#ifndef TICKER_BUILD_TIMEBUDGET_H
#define TICKER_BUILD_TIMEBUDGET_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <mutex>

namespace ticker::build {

/// Time limit of all runs of one submission together; each run also has its own limits. Safe to
/// share between threads; parallel runs may exceed the budget by the limits of one run.
class TimeBudget {
public:
    explicit TimeBudget(const sandbox::TimeLimits& all) : all_(all) {}

    /// True if no time is left for another run.
    [[nodiscard]] bool isSpent() const;
    /// The limits of one run, reduced to the rest of the budget.
    [[nodiscard]] sandbox::Limits cut(sandbox::Limits limits) const;
    void spend(const sandbox::Outcome& outcome);

    /// Limits of all runs together.
    [[nodiscard]] const sandbox::TimeLimits& all() const { return all_; }

private:
    sandbox::TimeLimits all_;
    mutable std::mutex mutex_;
    sandbox::TimeLimits spent_;
};

}  // namespace ticker::build

#endif
