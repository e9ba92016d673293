#include <grader/build/TimeBudget.h>

#include <algorithm>

namespace ticker::build {
namespace {

// RLIMIT_CPU counts whole seconds, so a run gets at least one.
constexpr double kLeastSeconds = 1.0;

}  // namespace

bool TimeBudget::isSpent() const {
    const std::lock_guard lock{mutex_};
    return all_.cpuSeconds - spent_.cpuSeconds < kLeastSeconds ||
           all_.wallSeconds - spent_.wallSeconds < kLeastSeconds;
}

sandbox::Limits TimeBudget::cut(sandbox::Limits limits) const {
    const std::lock_guard lock{mutex_};
    limits.cpuSeconds = std::clamp(all_.cpuSeconds - spent_.cpuSeconds, kLeastSeconds,
                                   std::max(kLeastSeconds, limits.cpuSeconds));
    limits.wallSeconds = std::clamp(all_.wallSeconds - spent_.wallSeconds, kLeastSeconds,
                                    std::max(kLeastSeconds, limits.wallSeconds));
    return limits;
}

void TimeBudget::spend(const sandbox::Outcome& outcome) {
    const std::lock_guard lock{mutex_};
    spent_.cpuSeconds += outcome.cpuMs / 1000.0;
    spent_.wallSeconds += outcome.wallMs / 1000.0;
}

}  // namespace ticker::build
