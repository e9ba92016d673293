#ifndef TICKER_BASE_WORKERS_H
#define TICKER_BASE_WORKERS_H

#include <cstddef>
#include <functional>

namespace ticker {

/// Calls work(0) ... work(count - 1), each once, on `workers` threads, of which the calling thread
/// is one. After an exception no further call begins, and the first exception is thrown at the end.
void onWorkers(int workers, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace ticker

#endif
