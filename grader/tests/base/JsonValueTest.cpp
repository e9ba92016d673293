#include <grader/base/JsonValue.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace ticker {
namespace {

std::string complaint(const std::function<void()>& work) {
    try {
        work();
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
    return "nothing was thrown";
}

constexpr const char* kText = "{\n\"b\": [1, true,\n\"x\"],\n\"a\": null}";

TEST(JsonValue, ReadsValuesAndKeepsTheOrderOfMembers) {
    const JsonValue top = JsonValue::parse(kText, "f");
    EXPECT_EQ(top.members().front().first, "b");
    const auto items = top.at("b").items();
    ASSERT_EQ(items.size(), 3U);
    EXPECT_EQ(items[0].number(), 1.0);
    EXPECT_TRUE(items[1].flag());
    EXPECT_EQ(items[2].text(), "x");
    EXPECT_EQ(items[0].asText(), std::nullopt);
    EXPECT_TRUE(top.at("a").isNull());
    EXPECT_FALSE(items[0].has("a"));
}

TEST(JsonValue, NamesFileLinePlaceAndWhatWasExpected) {
    const JsonValue top = JsonValue::parse(kText, "f");
    EXPECT_EQ(complaint([&] { static_cast<void>(top.at("b").items()[2].number()); }),
              "f:3: /b/2: expected a number");
    EXPECT_EQ(complaint([&] { static_cast<void>(top.at("c")); }),
              "f:1: the file: expected an object with a member \"c\"");
    EXPECT_EQ(complaint([] { static_cast<void>(JsonValue::parse("{\n!", "f")); }).substr(0, 13),
              "f:2: not JSON");
    static constexpr std::array<std::string_view, 2> kNames{"aa", "b"};
    EXPECT_EQ(complaint([&] { top.allowOnly(kNames); }).substr(0, 38),
              "f:4: /a: expected no member of this na");
}

TEST(JsonValue, SpeaksInTheWordsOfItsFile) {
    const JsonValue top =
        JsonValue::parse("[{\"b\": 1, \"a\": 2}]", "f", {"all", "a member", true});
    EXPECT_EQ(complaint([&] { static_cast<void>(top.at("c")); }),
              "f:1: all: expected a member \"c\", found [{\"a\":2,\"b\":1}]");
}

}  // namespace
}  // namespace ticker
