#include "ClassOnDisk.h"

#include <grader/session/Server.h>

#include <gtest/gtest.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

namespace ticker::session {
namespace {

const std::string kNameToEscape = "J\xC3\xBCrgen, 100% \"x\" #1?_12";
const std::string kToken = "0123456789abcdef0123456789abcdef";

/// A session on a free port, and a browser.
class OnTheNetwork : public testing::Test {
protected:
    OnTheNetwork() {
        client_.set_keep_alive(true);
        client_.set_default_headers({{"Host", host()}});
        EXPECT_EQ(statusOf(at("")), 200);  // it runs now, and can be stopped
    }
    ~OnTheNetwork() override { server_.stop(); }
    OnTheNetwork(const OnTheNetwork&) = delete;
    OnTheNetwork& operator=(const OnTheNetwork&) = delete;

    [[nodiscard]] std::string host() const {
        return "127.0.0.1:" + std::to_string(server_.access().port);
    }
    [[nodiscard]] static std::string at(const std::string& path) {
        return "/" + kToken + "/" + path;
    }

    [[nodiscard]] int statusOf(const std::string& path, const httplib::Headers& headers = {}) {
        const auto result = client_.Get(path, headers);
        return result ? result->status : -1;
    }
    [[nodiscard]] int post(const httplib::Headers& headers, const std::string& path) {
        const std::string body = R"({"decisions": [{"submission": "bob", "version": 0,
            "ruling": "awarded", "comment": "", "who": "ann"}]})";
        const auto result = client_.Post(path, headers, body, "application/json");
        return result ? result->status : -1;
    }
    [[nodiscard]] bool isDecided() const { return !store::Store{class_.out()}.decisions().empty(); }

    tests::ClassOnDisk class_{{kNameToEscape, "bob"}};
    ClassView view_{class_.out()};
    Server server_{view_, {kToken, 0}, 0};
    std::jthread serving_{[this] { server_.serve(); }};
    httplib::Client client_{"127.0.0.1", server_.access().port};
};

TEST_F(OnTheNetwork, GivesThePageAndTheClassToWhoKnowsTheToken) {
    EXPECT_EQ(server_.address(), "http://" + host() + "/" + kToken + "/");
    const auto page = client_.Get(at(""));
    ASSERT_TRUE(page);
    EXPECT_EQ(page->status, 200);
    EXPECT_NE(page->get_header_value("Content-Security-Policy").find("default-src 'none'"),
              std::string::npos);
    for (const char* path :
         {"main.js", "viewer.js", "session.css", "class", "pictures?name=bob",
          "submission?name=bob", "of/bob/images/bump-mapping.png", "of/bob/report.html"})
        EXPECT_EQ(statusOf(at(path)), 200) << path;
    EXPECT_EQ(statusOf(at("submission?name=J%C3%BCrgen%2C%20100%25%20%22x%22%20%231%3F_12")), 200);
    EXPECT_EQ(
        statusOf(at("of/J%C3%BCrgen%2C%20100%25%20%22x%22%20%231%3F_12/images/bump-mapping.png")),
        200);
}

TEST_F(OnTheNetwork, LetsNobodyElseIn) {
    for (const std::string& path : {std::string{"/"}, std::string{"/class"}, std::string{""},
                                    "/" + std::string(32, '0') + "/class", "/" + kToken + "0/class",
                                    "/x" + at("class"), std::string{"/../"}})
        EXPECT_NE(statusOf(path.empty() ? "/" : path), 200) << path;
    for (const char* name : {"evil.example", "evil.example:80", "127.0.0.1", "127.0.0.1:1", ""})
        EXPECT_EQ(statusOf(at("class"), {{"Host", name}}), 403) << name;
}

TEST_F(OnTheNetwork, KeepsADecisionOfItsOwnPageAlone) {
    const httplib::Headers own{{"X-Ticker", kToken}, {"Origin", "http://" + host()}};
    EXPECT_EQ(post({{"Origin", "http://" + host()}}, at("decide")), 403) << "a form can send that";
    EXPECT_EQ(post({{"X-Ticker", kToken}, {"Origin", "http://evil.example"}}, at("decide")), 403);
    EXPECT_EQ(post({{"X-Ticker", kToken}, {"Origin", "null"}}, at("decide")), 403);
    EXPECT_EQ(post({{"X-Ticker", kToken}}, at("decide")), 403);
    EXPECT_EQ(post(own, "/decide"), 403);
    EXPECT_FALSE(isDecided());
    EXPECT_EQ(post(own, at("decide")), 200);
    EXPECT_TRUE(isDecided());
}

TEST_F(OnTheNetwork, ChangesNothingByAGet) {
    const httplib::Headers own{{"X-Ticker", kToken}, {"Origin", "http://" + host()}};
    EXPECT_EQ(statusOf(at("decide?submission=bob&version=0&ruling=awarded"), own), 404);
    for (const char* method : {"PUT", "DELETE", "PATCH", "OPTIONS"}) {
        httplib::Request request;
        request.method = method;
        request.path = at("decide");
        request.headers = own;
        const auto result = client_.send(request);
        EXPECT_TRUE(result && result->status == 403) << method;
    }
    EXPECT_FALSE(isDecided());
}

TEST_F(OnTheNetwork, SaysThatARequestIsTooLarge) {
    const httplib::Headers own{{"X-Ticker", kToken}, {"Origin", "http://" + host()}};
    const auto result =
        client_.Post(at("decide"), own, std::string(270'000, 'x'), "application/json");
    ASSERT_TRUE(result);
    EXPECT_EQ(result->status, 413);
    const auto said = nlohmann::json::parse(result->body, nullptr, false);
    EXPECT_TRUE(said.is_object() && said.contains("error"))
        << "the page takes an answer without JSON for none, and would ask for ever: "
        << result->body;
}

TEST_F(OnTheNetwork, CanBeStoppedBeforeItServes) {
    Server early{view_, {kToken, 0}, 0};
    early.stop();
    early.serve();  // ends
}

TEST_F(OnTheNetwork, ShowsReportsInAFrameOfTheirOwnMaking) {
    const auto report = client_.Get(at("of/bob/report.html"));
    ASSERT_TRUE(report);
    EXPECT_NE(report->get_header_value("Content-Security-Policy").find("sandbox"),
              std::string::npos);
    EXPECT_EQ(report->get_header_value("Cache-Control"), "no-store");
    EXPECT_EQ(report->get_header_value("Referrer-Policy"), "no-referrer");
}

/// A connection without the token.
class Stranger {
public:
    explicit Stranger(int port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0)
            << std::strerror(errno);
    }
    ~Stranger() { close(socket_); }
    Stranger(const Stranger&) = delete;
    Stranger& operator=(const Stranger&) = delete;

    void say(std::string_view text) const {
        static_cast<void>(send(socket_, text.data(), text.size(), MSG_NOSIGNAL));
    }
    /// True if the session ended the connection within this time.
    [[nodiscard]] bool isEnded(int milliseconds) const {
        pollfd waiting{socket_, POLLIN, 0};
        char byte = 0;
        return poll(&waiting, 1, milliseconds) > 0 && recv(socket_, &byte, 1, 0) <= 0;
    }

private:
    int socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
};

TEST_F(OnTheNetwork, AnswersItsPageWhateverNumberOfOthersHoldsConnections) {
    for (const char* said : {"", "GET /x HTTP/1.1\r\nHost: a\r\nX: ",
                             "POST /x HTTP/1.1\r\nHost: a\r\nContent-Length: 9\r\n\r\nx"}) {
        std::vector<std::unique_ptr<Stranger>> others;
        for (int i = 0; i < 100; ++i) {
            others.push_back(std::make_unique<Stranger>(server_.access().port));
            others.back()->say(said);
        }
        httplib::Client fresh{"127.0.0.1", server_.access().port};
        fresh.set_default_headers({{"Host", host()}});
        const auto result = fresh.Get(at("class"));
        EXPECT_TRUE(result && result->status == 200) << said;
        EXPECT_TRUE(others.front()->isEnded(-1)) << "only the newest stay";
    }
}

TEST_F(OnTheNetwork, EndsAConnectionThatSendsItsRequestByteByByte) {
    const Stranger slow{server_.access().port};
    slow.say("GET /x HTTP/1.1\r\nHost: a\r\nX: ");
    while (!slow.isEnded(100))  // a session that waits as long as bytes come never does
        slow.say("x");
}

TEST_F(OnTheNetwork, EndsARequestThatIsLargerThanAnyOfThePage) {
    const Stranger large{server_.access().port};
    large.say("GET /x HTTP/1.1\r\n");
    const std::string line = "X: " + std::string(4000, 'x') + "\r\n";
    int lines = 0;
    while (!large.isEnded(0) && ++lines < 100'000)
        large.say(line);
    EXPECT_LT(lines, 100'000) << "400 MB of head were taken in";
}

TEST_F(OnTheNetwork, RefusesAPortThatIsTaken) {
    EXPECT_THROW((Server{view_, {kToken, 0}, server_.access().port}), std::exception);
    const Server another{view_, {kToken, server_.access().port}, 0};
    EXPECT_NE(another.access().port, server_.access().port) << "the last one's is only a wish";
    ASSERT_TRUE(another.missed());
    EXPECT_EQ(addressOf(*another.missed()), server_.address());
    EXPECT_FALSE(server_.missed());
}

}  // namespace
}  // namespace ticker::session
