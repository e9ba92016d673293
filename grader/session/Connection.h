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

/// The connections that have not shown the token yet. Each takes a thread, so only the newest few
/// stay. May be shared by threads.
class Newcomers {
public:
    explicit Newcomers(std::size_t most) : most_(most) {}

    /// Adds a connection. With more than `most` connections the oldest one is closed; a read that
    /// waits for its data ends.
    void add(int socket);
    /// Removes a connection that has shown the token, or is about to be closed.
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

/// One request of a connection. The connection ends where all of the request, its head and its
/// body, takes longer than five seconds or is larger than any that the page sends; writing ends
/// with an error where nothing can be written for five seconds. Does not own the socket.
[[nodiscard]] std::unique_ptr<httplib::Stream> requestStream(int socket, std::size_t mostBytes);

}  // namespace ticker::session

#endif
