#include "FakeKit.h"

#include <raytracer/serve/Door.h>
#include <student_template/framework/app/view/PageFiles.h>
#include <student_template/framework/app/view/ViewServer.h>

#include <gtest/gtest.h>
#include <httplib.h>

#include <chrono>
#include <future>
#include <string>
#include <thread>
#include <vector>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

// Answers every question as a right solution would: a line, and what belongs to it.
constexpr const char* kAnswers = R"(tab=$(printf '\t')
while IFS= read -r line; do
  number=${line#*"$tab"}
  printf 'part %s 10\nhead\nbytes' "${number%%"$tab"*}"
done)";

/// The page's server on a free port, and a browser. The kit's program gives questions back.
class ViewServerTest : public testing::Test {
protected:
    explicit ViewServerTest(const std::string& program = FakeKit::kEcho) : kit_(program) {
        EXPECT_EQ(get("").status, 200);  // it runs now, and can be stopped
    }
    ~ViewServerTest() override {
        studio_.board().close();
        server_.stop();
    }
    ViewServerTest(const ViewServerTest&) = delete;
    ViewServerTest& operator=(const ViewServerTest&) = delete;

    /// "http://127.0.0.1:8123"
    [[nodiscard]] std::string origin() const {
        return server_.address().substr(0, server_.address().find('/', 7));
    }
    /// "/<token>/"
    [[nodiscard]] std::string root() const { return server_.address().substr(origin().size()); }
    [[nodiscard]] std::string token() const { return root().substr(1, root().size() - 2); }
    [[nodiscard]] httplib::Headers ofThePage() const {
        return {{"X-Ticker", token()}, {"Origin", origin()}};
    }

    /// A status of -1: there was no answer.
    static httplib::Response answerOf(const httplib::Result& result) {
        httplib::Response none;
        none.status = -1;
        return result ? *result : none;
    }
    httplib::Response get(const std::string& rest, const httplib::Headers& headers = {}) {
        return answerOf(client_.Get(root() + rest, headers));
    }
    httplib::Response post(const std::string& path, const std::string& body,
                           const httplib::Headers& headers,
                           const char* type = "application/x-www-form-urlencoded") {
        return answerOf(client_.Post(path, headers, body, type));
    }

    FakeKit kit_;
    Studio studio_{kit_.home(),
                   parseOptions(std::vector<std::string>{
                       "--view", (kit_.home().scenes / "room.xml").string(), "--bounces", "5"})};
    ViewServer server_{studio_};
    std::jthread serving_{[this] { server_.serve(); }};
    httplib::Client client_{origin()};
};

/// The same where the solution answers.
class ViewServerOfASolution : public ViewServerTest {
protected:
    ViewServerOfASolution() : ViewServerTest(kAnswers) {}
};

TEST_F(ViewServerTest, GivesThePageToWhoKnowsTheToken) {
    EXPECT_TRUE(isToken(token()));
    const httplib::Response page = get("");
    EXPECT_EQ(page.body, viewHtml());
    EXPECT_EQ(page.get_header_value("Content-Security-Policy"), kPagePolicy);
    EXPECT_EQ(page.get_header_value("Cache-Control"), "no-store");
    EXPECT_EQ(get("view.css").body, viewCss());
    EXPECT_EQ(get("view.css").get_header_value("Content-Type"), "text/css; charset=utf-8");
    EXPECT_EQ(get("view.js").body, viewJs());
    for (const char* words : {"stopped: `The build", "stopped: `Your code is built", "unbuilt: "})
        EXPECT_NE(viewJs().find(words), std::string::npos) << words;
    EXPECT_EQ(get("no-such-file").status, 404);
}

TEST_F(ViewServerTest, LetsNobodyElseIn) {
    for (const char* path : {"/", "/0123456789abcdef0123456789abcdef/", "/view.js"}) {
        const httplib::Response answer = answerOf(client_.Get(path));
        EXPECT_EQ(answer.status, 403) << path;
        EXPECT_EQ(answer.body, "not here\n");
    }
    // A name that another site points to this machine.
    EXPECT_EQ(get("", {{"Host", "evil.example"}}).status, 403);
}

TEST_F(ViewServerTest, TellsTheNewsAsJsonThatIsNotCompressed) {
    const httplib::Response news = get("news?after=0", {{"Accept-Encoding", "gzip"}});
    EXPECT_EQ(news.get_header_value("Content-Type"), "application/octet-stream");
    EXPECT_FALSE(news.has_header("Content-Encoding"));
    EXPECT_EQ(Json::parse(news.body)["started"]["bounces"], "5");
    EXPECT_TRUE(Json::parse(get("news?after=nonsense").body).contains("started"));
}

// The viewer's end would wait for connections that are kept: five seconds after Ctrl-C.
TEST_F(ViewServerTest, KeepsNoConnectionOpen) {
    EXPECT_EQ(get("").get_header_value("Connection"), "close");
}

TEST_F(ViewServerTest, PassesOnWhatTheSolutionCannotAnswer) {
    const httplib::Response pixel = get("pixel?x=3&y=4");
    EXPECT_EQ(pixel.status, 409);
    EXPECT_NE(pixel.body.find("\t3\t4\t--view\t"), std::string::npos) << pixel.body;
    const httplib::Response point = get("point?x=0.5&y=-1&z=2");
    EXPECT_EQ(point.status, 409);
    EXPECT_NE(point.body.find("\t0.5\t-1\t2\t--view\t"), std::string::npos) << point.body;
    EXPECT_EQ(get("pixel?x=640&y=4").body, "there is no such pixel");
    EXPECT_EQ(get("pixel?x=3&y=480").body, "there is no such pixel");
    EXPECT_EQ(get("pixel?x=3").body, "there is no such pixel");
    EXPECT_EQ(get("point?x=0.5&y=up&z=2").body, "no such point");
    EXPECT_EQ(get("pinhole").status, 409);
}

TEST_F(ViewServerOfASolution, GivesTheAnswersOfTheSolution) {
    EXPECT_EQ(get("pixel?x=3&y=4").status, 200);
    EXPECT_EQ(get("pixel?x=3&y=4").body, "head\nbytes");
    EXPECT_EQ(get("point?x=0&y=0&z=0").body, "head\nbytes");
    EXPECT_EQ(get("pinhole").body, "bytes");
}

TEST_F(ViewServerTest, ChangesSettingsForItsOwnPageAlone) {
    const auto bounces = [&] {
        return Json::parse(get("news?after=0").body)["picture"]["settings"]["bounces"];
    };
    for (const httplib::Headers& foreign :
         {httplib::Headers{}, httplib::Headers{{"Origin", origin()}},
          httplib::Headers{{"X-Ticker", token()}, {"Origin", "http://evil.example"}}})
        EXPECT_EQ(post(root() + "settings", "bounces=3", foreign).status, 403);
    EXPECT_EQ(post(root() + "elsewhere", "bounces=3", ofThePage()).status, 403);
    EXPECT_EQ(post("/settings", "bounces=3", ofThePage()).status, 403);
    EXPECT_EQ(bounces(), "5");

    EXPECT_EQ(post(root() + "settings", "bounces=3", ofThePage()).status, 200);
    EXPECT_EQ(bounces(), "3");
    const httplib::Response refusal = post(root() + "settings", "bounces=-1", ofThePage());
    EXPECT_EQ(refusal.status, 400);
    EXPECT_NE(refusal.body.find("--bounces"), std::string::npos) << refusal.body;
    const std::string large(20'000, 'x');  // the library has a limit of its own for forms
    EXPECT_EQ(post(root() + "settings", large, ofThePage(), "text/plain").status, 413);
    EXPECT_EQ(bounces(), "3");
}

TEST_F(ViewServerTest, AnswersNobodyOnceItIsStopped) {
    server_.stop();
    serving_.join();
    EXPECT_FALSE(httplib::Client{origin()}.Get(root()));
}

// Who presses Ctrl-C at once asks for the end before the server runs.
TEST(ViewServerAtItsBeginning, EndsIfItIsStoppedBeforeItServes) {
    const FakeKit kit{FakeKit::kEcho};
    Studio studio{kit.home(),
                  parseOptions(std::vector<std::string>{
                      "--view", (kit.home().scenes / "room.xml").string(), "--bounces", "5"})};
    ViewServer server{studio};
    server.stop();
    std::future<void> served = std::async(std::launch::async, [&] { server.serve(); });
    EXPECT_EQ(served.wait_for(std::chrono::seconds{20}), std::future_status::ready);
    server.stop();
    studio.board().close();
}

}  // namespace
}  // namespace raytracer::view
