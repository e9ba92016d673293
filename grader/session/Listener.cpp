#include <grader/session/Listener.h>

#include <sys/socket.h>
#include <unistd.h>

#include <utility>

namespace ticker::session {

Listener::Listener(IsAllowed isAllowed, std::size_t largestRequest)
    : isAllowed_(std::move(isAllowed)), largestRequest_(largestRequest) {}

void Listener::queueMany() const {
    ::listen(svr_sock_, SOMAXCONN);
}

void Listener::end() {
    const socket_t socket = svr_sock_.exchange(INVALID_SOCKET);
    if (socket == INVALID_SOCKET) return;
    shutdown(socket, SHUT_RDWR);
    close(socket);
    connections_.stopReading();
}

bool Listener::process_and_close_socket(socket_t socket) {
    connections_.add(socket);
    bool isClosing = false;
    for (std::size_t left = kMostRequests; left > 0 && !isClosing; --left)
        if (svr_sock_ == INVALID_SOCKET || !isRequestComing(socket) ||
            !answerOne(socket, left == 1, isClosing))
            break;
    connections_.remove(socket);
    shutdown(socket, SHUT_RDWR);
    close(socket);
    return true;
}

bool Listener::answerOne(socket_t socket, bool isLast, bool& isClosing) {
    const auto stream = requestStream(socket, largestRequest_);
    return process_request(*stream, isLast, isClosing, [&](httplib::Request& request) {
        if (isAllowed_(request)) connections_.admit(socket);
        // Compression would take longer than sending within one machine: a second for a class of
        // 500.
        request.headers.erase("Accept-Encoding");
    });
}

}  // namespace ticker::session
