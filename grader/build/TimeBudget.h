#ifndef TICKER_BUILD_TIMEBUDGET_H
#define TICKER_BUILD_TIMEBUDGET_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <mutex>

namespace ticker::build {

/// The time that all runs of one submission may take together, each within its own limits. May be
/// shared by threads; runs side by side may go beyond it by what one of them may take.
class TimeBudget {
public:
    explicit TimeBudget(const sandbox::TimeLimits& all) : all_(all) {}

    /// True where nothing is left for another run.
    [[nodiscard]] bool isSpent() const;
    /// The limits of one run, cut to what is left of the whole.
    [[nodiscard]] sandbox::Limits cut(sandbox::Limits limits) const;
    void spend(const sandbox::Outcome& outcome);

    /// What all runs together may take.
    [[nodiscard]] const sandbox::TimeLimits& all() const { return all_; }

private:
    sandbox::TimeLimits all_;
    mutable std::mutex mutex_;
    sandbox::TimeLimits spent_;
};

}  // namespace ticker::build

#endif
