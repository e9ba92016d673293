#ifndef TICKER_SESSION_SERVER_H
#define TICKER_SESSION_SERVER_H

#include <grader/session/Access.h>
#include <grader/session/ClassView.h>

#include <memory>
#include <optional>
#include <string>

namespace ticker::session {

/// "http://127.0.0.1:8123/<token>/"
[[nodiscard]] std::string addressOf(const Access& access);

/// Serves a class on 127.0.0.1 to clients that have its token. A GET changes nothing; a POST must
/// carry a header that no other site's page can send.
class Server {
public:
    /// Binds to a port; requests wait until `serve`. @param port  0: the last session's, or any if
    /// that is in use.
    /// @throws raytracer::InputError if this port is in use.
    Server(ClassView& view, Access access, int port);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Token and the actual port.
    [[nodiscard]] const Access& access() const;
    [[nodiscard]] std::string address() const;
    /// The last session's access if its port was in use, so that this session has another address.
    /// Browsers may keep decisions for the last one's: it is the one to be stored.
    [[nodiscard]] const std::optional<Access>& missed() const;

    /// Answers requests until `stop`, which another thread may call, also before this has begun.
    void serve();
    void stop();

private:
    class Routes;
    std::unique_ptr<Routes> routes_;
};

}  // namespace ticker::session

#endif
