#include <grader/build/TimeBudget.h>

#include <algorithm>

namespace ticker::build {
namespace {

using Seconds = std::chrono::duration<double>;
using Milliseconds = std::chrono::duration<double, std::milli>;

// RLIMIT_CPU counts whole seconds, so a run gets at least one.
constexpr double kLeastSeconds = 1.0;

}  // namespace

sandbox::TimeLimits TimeBudget::rest() const {
    Clock::duration lasted{};
    for (const Span& span : spans_)
        lasted += span.end - span.begin;
    return {all_.cpuSeconds - cpuSeconds_, all_.wallSeconds - Seconds{lasted}.count()};
}

bool TimeBudget::isSpent() const {
    const std::lock_guard lock{mutex_};
    const sandbox::TimeLimits left = rest();
    return left.cpuSeconds < kLeastSeconds || left.wallSeconds < kLeastSeconds;
}

sandbox::Limits TimeBudget::cut(sandbox::Limits limits) const {
    const std::lock_guard lock{mutex_};
    const sandbox::TimeLimits left = rest();
    limits.cpuSeconds =
        std::clamp(left.cpuSeconds, kLeastSeconds, std::max(kLeastSeconds, limits.cpuSeconds));
    limits.wallSeconds =
        std::clamp(left.wallSeconds, kLeastSeconds, std::max(kLeastSeconds, limits.wallSeconds));
    return limits;
}

void TimeBudget::spend(const sandbox::Outcome& outcome, Clock::time_point ended) {
    const auto wall = std::chrono::duration_cast<Clock::duration>(Milliseconds{outcome.wallMs});
    Span span{ended - wall, ended};
    const std::lock_guard lock{mutex_};
    cpuSeconds_ += outcome.cpuMs / 1000.0;
    std::erase_if(spans_, [&](const Span& other) {
        if (other.end <= span.begin || other.begin >= span.end) return false;
        span = {std::min(span.begin, other.begin), std::max(span.end, other.end)};
        return true;
    });
    spans_.push_back(span);
}

}  // namespace ticker::build
