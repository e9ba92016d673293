#include "RunningTicker.h"

#include <grader/tests/session/ClassOnDisk.h>

#include <gtest/gtest.h>
#include <httplib.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// `ticker session` over a class of two, and a page of it.
class SessionVerb : public testing::Test {
protected:
    /// Decides about bob. @return  The status of the answer.
    int decide() {
        const std::string host = "127.0.0.1:" + std::to_string(port());
        const httplib::Headers own{{"X-Ticker", token()}, {"Origin", "http://" + host}};
        const auto result = client_.Post("/" + token() + "/decide", own,
                                         R"({"decisions": [{"submission": "bob", "version": 0,
            "ruling": "awarded", "comment": "", "who": "ann"}]})",
                                         "application/json");
        return result ? result->status : -1;
    }

    /// Requests the class until `isSo` is true; false if the session no longer answers.
    bool becomes(const std::function<bool()>& isSo) {
        constexpr int kMost = 200'000;  // the tables are written every three seconds
        for (int i = 0; i < kMost; ++i) {
            if (isSo()) return true;
            const auto result = client_.Get("/" + token() + "/class");
            if (!result || result->status != 200) return false;
        }
        return false;
    }

    [[nodiscard]] std::string errors() const { return textOf(folder_.path() / "errors"); }
    [[nodiscard]] static std::string textOf(const fs::path& file) {
        std::ifstream stream{file, std::ios::binary};
        return {std::istreambuf_iterator<char>{stream}, {}};
    }

    tests::ClassOnDisk class_{{"ann", "bob"}};
    tests::TemporaryFolder folder_;
    RunningTicker session_{{"session", class_.out().string(), "--quiet"},
                           (folder_.path() / "errors").string()};

private:
    // "http://127.0.0.1:8123/<token>/"
    [[nodiscard]] int port() const { return std::stoi(address_.substr(address_.rfind(':') + 1)); }
    [[nodiscard]] std::string token() const {
        const std::size_t from = address_.find('/', address_.rfind(':')) + 1;
        return address_.substr(from, address_.rfind('/') - from);
    }

    std::string address_ = session_.readLine().value_or("http://127.0.0.1:0//");
    httplib::Client client_{"127.0.0.1", port()};
};

TEST_F(SessionVerb, TellsThatTheTablesCannotBeWrittenAndGoesOnAndEndsWithThatError) {
    std::ofstream{class_.out() / "ann" / "result.json"} << "{";
    EXPECT_EQ(decide(), 200);
    EXPECT_TRUE(becomes([&] { return errors().find("ann/result.json") != std::string::npos; }));
    session_.send(SIGTERM);
    EXPECT_EQ(session_.wait(), 2) << errors();
}

TEST_F(SessionVerb, WritesTheTablesOnceTheErrorHasGone) {
    const fs::path result = class_.out() / "ann" / "result.json";
    const std::string whole = textOf(result);
    std::ofstream{result} << "{";
    EXPECT_EQ(decide(), 200);
    EXPECT_TRUE(becomes([&] { return !errors().empty(); }));
    std::ofstream{result} << whole;
    EXPECT_TRUE(becomes([&] { return fs::exists(class_.out() / "summary.csv"); })) << errors();
    session_.send(SIGTERM);
    EXPECT_EQ(session_.wait(), 0) << errors();
    EXPECT_NE(textOf(class_.out() / "summary.csv").find("awarded"), std::string::npos);
}

}  // namespace
}  // namespace ticker::cli
