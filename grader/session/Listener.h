#ifndef TICKER_SESSION_LISTENER_H
#define TICKER_SESSION_LISTENER_H

#include <grader/session/Connection.h>

#include <httplib.h>

#include <cstddef>
#include <functional>

namespace ticker::session {

/// Largest number of open connections that have not sent the token yet.
inline constexpr std::size_t kMostNewcomers = 16;
/// Largest number of requests of one connection.
inline constexpr std::size_t kMostRequests = 1000;

/// The library's server with limits on slow connections. Without them, clients that send a byte now
/// and then could occupy all threads, and the page's own requests would wait for ever.
class Listener : public httplib::Server {
public:
    using IsAllowed = std::function<bool(const httplib::Request&)>;

    /// @param isAllowed  True for a request with the token.
    Listener(IsAllowed isAllowed, std::size_t largestRequest);

    /// Makes the queue of connections that wait to be accepted longer than the library's five: a
    /// connection that does not fit is tried again only after a second.
    void queueMany() const;

    /// Ends `listen_after_bind`, or lets it end at once if it has not begun; then the library's
    /// `stop` does nothing. Requests that have arrived are answered, idle connections are closed.
    void end();

private:
    bool process_and_close_socket(socket_t socket) override;
    bool answerOne(socket_t socket, bool isLast, bool& isClosing);

    IsAllowed isAllowed_;
    std::size_t largestRequest_;
    OpenConnections connections_{kMostNewcomers};
};

}  // namespace ticker::session

#endif
