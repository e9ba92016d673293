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

/// The open connections of a server. Each occupies a thread, so of those that have not sent the
/// token yet only the newest few are kept open. Threads may share it.
class OpenConnections {
public:
    /// @param mostNewcomers  Largest number of connections that have not sent the token.
    explicit OpenConnections(std::size_t mostNewcomers) : mostNewcomers_(mostNewcomers) {}

    /// Adds a connection. If too many have not sent the token, the oldest of them is closed, which
    /// ends a read that waits for its data.
    void add(int socket);
    /// Says that a connection has sent the token.
    void admit(int socket);
    /// Removes a connection that is about to be closed.
    void remove(int socket);
    /// Lets no connection read anything that has not arrived yet, also those that are added later.
    /// Idle ones end at once; a request that has arrived is still answered.
    void stopReading();

private:
    std::size_t mostNewcomers_;
    std::mutex mutex_;
    std::list<int> newcomers_;  // oldest first
    std::list<int> admitted_;
    bool isStopped_ = false;
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
