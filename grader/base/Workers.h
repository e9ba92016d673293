#ifndef TICKER_BASE_WORKERS_H
#define TICKER_BASE_WORKERS_H

#include <cstddef>
#include <functional>

namespace ticker {

/// Calls work(0) ... work(count - 1), each once, on so many threads; the calling thread is one of
/// them. The first exception keeps further calls from beginning and is thrown again at the end.
void onWorkers(int workers, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace ticker

#endif
