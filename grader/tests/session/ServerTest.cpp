#include "ClassOnDisk.h"

#include <grader/session/Server.h>

#include <gtest/gtest.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <thread>

namespace ticker::session {
namespace {

const std::string kOddName = "J\xC3\xBCrgen, 100% \"x\" #1?_12";
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

    [[nodiscard]] std::string host() const {
        return "127.0.0.1:" + std::to_string(server_.access().port);
    }
    [[nodiscard]] static std::string at(const std::string& path) {
        return "/" + kToken + "/" + path;
    }

    [[nodiscard]] int statusOf(const std::string& path, const httplib::Headers& headers = {}) {
        const auto result = client_.Get(path.c_str(), headers);
        return result ? result->status : -1;
    }
    [[nodiscard]] int post(const httplib::Headers& headers, const std::string& path) {
        const std::string body = R"({"submission": "bob", "version": 0, "ruling": "awarded",
                                     "comment": "", "who": "ann"})";
        const auto result = client_.Post(path.c_str(), headers, body, "application/json");
        return result ? result->status : -1;
    }
    [[nodiscard]] bool isDecided() const { return !store::Store{class_.out()}.decisions().empty(); }

    tests::ClassOnDisk class_{{kOddName, "bob"}};
    ClassView view_{class_.out()};
    Server server_{view_, {kToken, 0}, 0};
    std::jthread serving_{[this] { server_.serve(); }};
    httplib::Client client_{"127.0.0.1", server_.access().port};
};

TEST_F(OnTheNetwork, GivesThePageAndTheClassToWhoKnowsTheToken) {
    EXPECT_EQ(server_.address(), "http://" + host() + "/" + kToken + "/");
    const auto page = client_.Get(at("").c_str());
    ASSERT_TRUE(page);
    EXPECT_EQ(page->status, 200);
    EXPECT_NE(page->get_header_value("Content-Security-Policy").find("default-src 'none'"),
              std::string::npos);
    for (const char* path : {"session.js", "session.css", "class", "submission?name=bob",
                             "of/bob/images/bump-mapping.png", "report?name=bob"})
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

TEST_F(OnTheNetwork, ShowsReportsInAFrameOfTheirOwnMaking) {
    const auto report = client_.Get(at("report?name=bob").c_str());
    ASSERT_TRUE(report);
    EXPECT_NE(report->get_header_value("Content-Security-Policy").find("sandbox"),
              std::string::npos);
    EXPECT_EQ(report->get_header_value("Cache-Control"), "no-store");
    EXPECT_EQ(report->get_header_value("Referrer-Policy"), "no-referrer");
}

TEST_F(OnTheNetwork, RefusesAPortThatIsTaken) {
    EXPECT_THROW((Server{view_, {kToken, 0}, server_.access().port}), std::exception);
    const Server another{view_, {kToken, server_.access().port}, 0};
    EXPECT_NE(another.access().port, server_.access().port) << "the last one's is only a wish";
}

}  // namespace
}  // namespace ticker::session
