#include <student_template/framework/app/view/Board.h>
#include <student_template/framework/app/view/Json.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>
#include <thread>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

Board::Piece piece(const char* rgb, bool isWhole) {
    return {"{}", rgb, isWhole};
}

TEST(Board, TellsOnlyWhatIsNew) {
    Board board;
    board.set("build", "{\"state\":\"building\"}");
    const Json first = Json::parse(board.newsAfter(0));
    EXPECT_EQ(first["build"]["state"], "building");
    board.set("tests", "1");
    const Json second = Json::parse(board.newsAfter(first["version"].get<std::uint64_t>()));
    EXPECT_FALSE(second.contains("build"));
    EXPECT_EQ(second["tests"], 1);
}

TEST(Board, LetsAWaitingPageGoWhenSomethingComes) {
    Board board;
    std::jthread later{[&] { board.set("trouble", "\"x\""); }};
    EXPECT_EQ(Json::parse(board.newsAfter(0))["trouble"], "x");
}

TEST(Board, KeepsThePiecesOfTheNewestPictureThatAreStillSeen) {
    Board board;
    board.beginPicture(1, "{}");
    board.addPiece(1, piece("a", true));
    board.addPiece(1, piece("b", false));
    EXPECT_EQ(Json::parse(board.newsAfter(0))["pieces"].size(), 2U);
    board.addPiece(1, piece("c", true));
    EXPECT_EQ(Json::parse(board.newsAfter(0))["pieces"].size(), 1U);
    board.beginPicture(2, "{}");
    board.addPiece(1, piece("late", false));
    EXPECT_TRUE(Json::parse(board.newsAfter(0))["pieces"].empty());
}

TEST(Board, EndsAllWaiting) {
    Board board;
    std::jthread waiting{[&] { static_cast<void>(board.newsAfter(0)); }};
    board.close();
}

TEST(ViewJson, EscapesWhatAStudentPrints) {
    const std::string hostile = "\"</script>\\\n\x01\x7F";
    EXPECT_EQ(Json::parse(json(hostile)).get<std::string>(), hostile);
    EXPECT_EQ(json(std::numeric_limits<double>::quiet_NaN()), "null");
    EXPECT_EQ(json(0.25), "0.25");
    EXPECT_EQ(json(ColourRGB{1.0, 0.5, 0.0}), "\"#ff8000\"");
}

TEST(ViewJson, WritesBase64) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xFF\x00\x80"), "/w==");  // a literal ends at its first zero
}

}  // namespace
}  // namespace raytracer::view
