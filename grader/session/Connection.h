#ifndef TICKER_SESSION_CONNECTION_H
#define TICKER_SESSION_CONNECTION_H

#include <chrono>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>

namespace httplib {
class Stream;
}

namespace ticker::session {

/// The connections that have not sent the token yet. Each occupies a thread, so only the newest
/// few are kept open. Threads may share it.
class Newcomers {
public:
    explicit Newcomers(std::size_t most) : most_(most) {}

    /// Adds a connection. If there are more than `most`, the oldest one is closed, which ends a
    /// read that waits for its data.
    void add(int socket);
    /// Removes a connection that has sent the token, or is about to be closed.
    void remove(int socket);

private:
    std::size_t most_;
    std::mutex mutex_;
    std::list<int> sockets_;  // oldest first
};

/// Longest silence of a connection between two requests.
inline constexpr std::chrono::seconds kLongestIdle{2};

/// Waits for the first byte of a request; false if it does not come in time.
[[nodiscard]] bool isRequestComing(int socket);

/// A stream for one request of a connection. Reading fails if the request, head and body, takes
/// longer than five seconds or has more than `mostBytes`; writing fails if nothing can be written
/// for five seconds. It does not own the socket.
[[nodiscard]] std::unique_ptr<httplib::Stream> requestStream(int socket, std::size_t mostBytes);

}  // namespace ticker::session

#endif
