#ifndef TICKER_SESSION_LISTENER_H
#define TICKER_SESSION_LISTENER_H

#include <grader/session/Connection.h>

#include <httplib.h>

#include <cstddef>
#include <functional>

namespace ticker::session {

/// How many connections may be open that have not shown the token yet.
inline constexpr std::size_t kMostNewcomers = 16;
/// How many requests a connection may have.
inline constexpr std::size_t kMostRequests = 1000;

/// The library's server, which alone would wait as long as a byte comes now and then, for as many
/// connections as there are threads: then the page's own wait for ever.
class Listener : public httplib::Server {
public:
    using IsAllowed = std::function<bool(const httplib::Request&)>;

    /// @param isAllowed  True for a request that has shown the token.
    Listener(IsAllowed isAllowed, std::size_t largestRequest);

    /// Lets more than the library's five connections wait to be accepted: one that finds no place
    /// tries again only after a second.
    void queueMany() const;

private:
    bool process_and_close_socket(socket_t socket) override;
    bool answerOne(socket_t socket, bool isLast, bool& isClosing);

    IsAllowed isAllowed_;
    std::size_t largestRequest_;
    Newcomers newcomers_{kMostNewcomers};
};

}  // namespace ticker::session

#endif
