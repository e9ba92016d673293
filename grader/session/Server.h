#ifndef TICKER_SESSION_SERVER_H
#define TICKER_SESSION_SERVER_H

#include <grader/session/Access.h>
#include <grader/session/ClassView.h>

#include <memory>
#include <string>

namespace ticker::session {

/// Serves a class on 127.0.0.1 to clients that have its token. A GET changes nothing; a POST must
/// carry a header that no other site's page can send.
class Server {
public:
    /// Binds to a port; requests wait until `serve`. @param port  0: the last session's, or any.
    /// @throws raytracer::InputError if this port is in use.
    Server(ClassView& view, Access access, int port);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Token and the actual port, to be stored for the next session.
    [[nodiscard]] const Access& access() const;
    /// "http://127.0.0.1:8123/<token>/"
    [[nodiscard]] std::string address() const;

    /// Answers requests until `stop`, which another thread may call, also before this has begun.
    void serve();
    void stop();

private:
    class Routes;
    std::unique_ptr<Routes> routes_;
};

}  // namespace ticker::session

#endif
