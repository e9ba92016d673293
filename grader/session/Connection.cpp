#include <grader/session/Connection.h>

#include <httplib.h>

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string>

namespace ticker::session {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kLongestRequest{5000};

/// True if the socket is ready, or has failed, before the deadline.
bool waitFor(int socket, short event, Clock::time_point deadline) {
    for (;;) {
        const auto left = std::chrono::ceil<milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) return false;
        pollfd waiting{socket, event, 0};
        const int ready = poll(&waiting, 1, static_cast<int>(left.count()));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) return false;
    }
}

bool isLater(ssize_t outcome) {
    return outcome < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

class RequestStream final : public httplib::Stream {
public:
    RequestStream(int socket, std::size_t mostBytes) : socket_(socket), bytesLeft_(mostBytes) {}

    [[nodiscard]] bool is_readable() const override { return waitFor(socket_, POLLIN, deadline_); }
    [[nodiscard]] bool is_writable() const override {
        return waitFor(socket_, POLLOUT, Clock::now() + kLongestRequest);
    }

    ssize_t read(char* bytes, std::size_t size) override {
        if (bytesLeft_ == 0 || Clock::now() >= deadline_) return giveUp();
        for (;;) {
            const ssize_t got = recv(socket_, bytes, std::min(size, bytesLeft_), MSG_DONTWAIT);
            if (got > 0) bytesLeft_ -= static_cast<std::size_t>(got);
            if (!isLater(got)) return got;
            if (!is_readable()) return giveUp();
        }
    }

    ssize_t write(const char* bytes, std::size_t size) override {
        for (;;) {
            const ssize_t sent = send(socket_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL);
            if (!isLater(sent)) return sent;
            if (!is_writable()) return -1;
        }
    }

    // The session accepts connections of this machine only, so the address is not needed.
    void get_remote_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
    void get_local_ip_and_port(std::string& /*ip*/, int& /*port*/) const override {}
    [[nodiscard]] socket_t socket() const override { return socket_; }

private:
    // The rest of a failed request must not be read as the next request.
    [[nodiscard]] ssize_t giveUp() const {
        shutdown(socket_, SHUT_RDWR);
        return -1;
    }

    int socket_;
    std::size_t bytesLeft_;
    Clock::time_point deadline_ = Clock::now() + kLongestRequest;
};

}  // namespace

void OpenConnections::add(int socket) {
    const std::scoped_lock lock{mutex_};
    if (isStopped_) shutdown(socket, SHUT_RD);
    newcomers_.push_back(socket);
    if (newcomers_.size() <= mostNewcomers_) return;
    shutdown(newcomers_.front(), SHUT_RDWR);
    newcomers_.pop_front();
}

void OpenConnections::admit(int socket) {
    const std::scoped_lock lock{mutex_};
    if (newcomers_.remove(socket) > 0) admitted_.push_back(socket);
}

void OpenConnections::remove(int socket) {
    const std::scoped_lock lock{mutex_};
    newcomers_.remove(socket);
    admitted_.remove(socket);
}

void OpenConnections::stopReading() {
    const std::scoped_lock lock{mutex_};
    isStopped_ = true;
    for (const auto* sockets : {&newcomers_, &admitted_})
        for (const int socket : *sockets)
            shutdown(socket, SHUT_RD);
}

bool isRequestComing(int socket) {
    return waitFor(socket, POLLIN, Clock::now() + kLongestIdle);
}

std::unique_ptr<httplib::Stream> requestStream(int socket, std::size_t mostBytes) {
    return std::make_unique<RequestStream>(socket, mostBytes);
}

}  // namespace ticker::session
