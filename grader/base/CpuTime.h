#ifndef TICKER_BASE_CPUTIME_H
#define TICKER_BASE_CPUTIME_H

#include <time.h>

namespace ticker {

/// The CPU time of the calling thread so far, in milliseconds.
[[nodiscard]] inline double threadCpuMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace ticker

#endif
