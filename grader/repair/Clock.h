#ifndef TICKER_REPAIR_CLOCK_H
#define TICKER_REPAIR_CLOCK_H

#include <grader/base/CpuTime.h>
#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <numeric>

namespace ticker::repair {

/// What the processes of an explanation do.
enum class Work { parse, compile, ask, prove };

/// Time that one explanation has taken: of this thread and of the processes it ran. It goes step by
/// step: each step ends at a time of its own, and all of them when all the time is used up. Belongs
/// to one thread.
class Clock {
public:
    explicit Clock(const sandbox::TimeLimits& all)
        : all_(all), stepEndMs_(1000.0 * all.cpuSeconds) {}

    /// Adds the CPU time of a process.
    void add(Work work, double cpuMs) { processesMs_.at(static_cast<std::size_t>(work)) += cpuMs; }
    /// CPU time so far.
    [[nodiscard]] double cpuMs() const {
        return std::accumulate(processesMs_.begin(), processesMs_.end(), threadMs());
    }
    /// CPU time of the processes that did this kind of work.
    [[nodiscard]] double cpuMs(Work work) const {
        return processesMs_.at(static_cast<std::size_t>(work));
    }

    /// Sets the end of the current step: `endMs` of CPU time, or all of it, whichever comes first.
    void endStepAt(double endMs) { stepEndMs_ = std::min(endMs, 1000.0 * all_.cpuSeconds); }
    [[nodiscard]] double stepEndMs() const { return stepEndMs_; }
    [[nodiscard]] bool isStepOver() const {
        return cpuMs() >= stepEndMs_ || wallSeconds() >= all_.wallSeconds;
    }

    /// Whether all the time is used up, whenever the step ends.
    [[nodiscard]] bool isAllUsedUp() const {
        return unusedMs() <= 0.0 || wallSeconds() >= all_.wallSeconds;
    }
    /// CPU time until then.
    [[nodiscard]] double unusedMs() const { return 1000.0 * all_.cpuSeconds - cpuMs(); }
    /// All the unused time as limits: at least a second each, since the kernel counts whole ones.
    [[nodiscard]] sandbox::TimeLimits unused() const {
        return {std::max(1.0, unusedMs() / 1000.0),
                std::max(1.0, all_.wallSeconds - wallSeconds())};
    }
    /// The limits of a process, reduced to the unused time.
    [[nodiscard]] sandbox::Limits cut(sandbox::Limits limits) const {
        const sandbox::TimeLimits most = unused();
        limits.cpuSeconds = std::min(limits.cpuSeconds, most.cpuSeconds);
        limits.wallSeconds = std::min(limits.wallSeconds, most.wallSeconds);
        return limits;
    }

private:
    [[nodiscard]] double threadMs() const { return threadCpuMs() - threadMs_; }
    [[nodiscard]] double wallSeconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    sandbox::TimeLimits all_;
    double stepEndMs_;
    double threadMs_ = threadCpuMs();
    std::array<double, 4> processesMs_{};
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ticker::repair

#endif
