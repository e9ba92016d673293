#include <grader/session/Connection.h>

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>

namespace ticker::session {
namespace {

/// The two ends of a connection.
class SocketPair {
public:
    SocketPair() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
    ~SocketPair() {
        for (const int end : ends_)
            close(end);
    }
    SocketPair(const SocketPair&) = delete;
    SocketPair& operator=(const SocketPair&) = delete;

    [[nodiscard]] int server() const { return ends_[0]; }
    [[nodiscard]] int client() const { return ends_[1]; }

private:
    std::array<int, 2> ends_{-1, -1};
};

/// What the server reads without waiting: the number of bytes, 0 at the end; nothing if it would
/// have to wait.
std::optional<ssize_t> readable(const SocketPair& connection) {
    char byte = 0;
    const ssize_t got = recv(connection.server(), &byte, 1, MSG_DONTWAIT);
    if (got < 0 && errno == EAGAIN) return std::nullopt;
    return got;
}

TEST(OpenConnections, EndIdleOnesAtOnceWhenStopped) {
    OpenConnections open{4};
    const SocketPair newcomer;
    const SocketPair admitted;
    open.add(newcomer.server());
    open.add(admitted.server());
    open.admit(admitted.server());
    EXPECT_EQ(readable(newcomer), std::nullopt);
    EXPECT_EQ(readable(admitted), std::nullopt);
    open.stopReading();
    EXPECT_EQ(readable(newcomer), 0);
    EXPECT_EQ(readable(admitted), 0);
}

TEST(OpenConnections, EndThoseThatComeAfterTheStop) {
    OpenConnections open{4};
    open.stopReading();
    const SocketPair late;
    open.add(late.server());
    EXPECT_EQ(readable(late), 0);
}

TEST(OpenConnections, StillReadARequestThatArrivedBeforeTheStopAndCanAnswerIt) {
    OpenConnections open{4};
    const SocketPair connection;
    open.add(connection.server());
    ASSERT_EQ(send(connection.client(), "d", 1, 0), 1);
    open.stopReading();
    EXPECT_EQ(readable(connection), 1);
    EXPECT_EQ(send(connection.server(), "k", 1, MSG_NOSIGNAL), 1);
    EXPECT_EQ(readable(connection), 0);
}

TEST(OpenConnections, LeaveOneAloneThatWasRemoved) {
    OpenConnections open{4};
    const SocketPair closed;
    open.add(closed.server());
    open.admit(closed.server());
    open.remove(closed.server());
    open.stopReading();
    EXPECT_EQ(readable(closed), std::nullopt) << "its number may be another connection's by now";
}

TEST(OpenConnections, CloseTheOldestOfTooManyWithoutTheToken) {
    OpenConnections open{2};
    const SocketPair admitted;
    const SocketPair first;
    const SocketPair second;
    const SocketPair third;
    open.add(admitted.server());
    open.admit(admitted.server());
    for (const SocketPair* newcomer : {&first, &second, &third})
        open.add(newcomer->server());
    EXPECT_EQ(readable(first), 0);
    EXPECT_EQ(readable(second), std::nullopt);
    EXPECT_EQ(readable(third), std::nullopt);
    EXPECT_EQ(readable(admitted), std::nullopt);
}

}  // namespace
}  // namespace ticker::session
