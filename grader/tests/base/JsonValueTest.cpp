#include <grader/base/JsonLines.h>
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

TEST(JsonValue, RefusesANumberThatNoDoubleHolds) {
    for (const char* number : {"1e999", "-1e999"})
        EXPECT_EQ(complaint([&] {
                      static_cast<void>(
                          JsonValue::parse("{\"a\": 1,\n\"b\": " + std::string{number} + "}", "f"));
                  }),
                  "f:2: a number is too large");
}

TEST(JsonValue, UsesTheWordsGivenToParseInItsErrors) {
    const JsonValue top =
        JsonValue::parse("[{\"b\": 1, \"a\": 2}]", "f", {"all", "a member", true});
    EXPECT_EQ(complaint([&] { static_cast<void>(top.at("c")); }),
              "f:1: all: expected a member \"c\", found [{\"a\":2,\"b\":1}]");
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i)
        all += text;
    return all;
}

TEST(JsonValue, RefusesATextThatNestsWithoutEnd) {
    const auto nested = [](std::size_t depth) {
        return repeated("\n[", depth) + repeated("]", depth);
    };
    EXPECT_NO_THROW(static_cast<void>(JsonValue::parse(nested(100), "f")));
    EXPECT_EQ(complaint([&] { static_cast<void>(JsonValue::parse(nested(1'000'000), "f")); }),
              "f:102: expected at most 100 objects and arrays inside each other");
    EXPECT_NO_THROW(
        static_cast<void>(JsonValue::parse("\"" + repeated("\\\"[{:", 2000) + "\"", "f")))
        << "brackets in a text are no nesting";
}

TEST(JsonValue, RefusesAnObjectWithMembersWithoutEnd) {
    std::string members = "\"a\": 0";
    for (int i = 1; i < 1000; ++i)
        members += ",\n\"" + std::to_string(i) + "\": [{}, {\"b\": 1}]";
    EXPECT_NO_THROW(static_cast<void>(JsonValue::parse("{" + members + "}", "f")));
    EXPECT_EQ(complaint([&] {
                  static_cast<void>(JsonValue::parse("{" + members + ",\n\"b\": 1}", "f"));
              }),
              "f:1001: expected at most 1000 members in an object");
}

TEST(JsonLines, FindsPlacesInATextWithLongNames) {
    const std::string name(1U << 20U, 'n');
    const std::string text =
        "{\n\"" + name + "\": [" + repeated("{\"a\": 1},", 100'000) + "\n{\"b\":\n[2, 3,\n4]}]}";
    EXPECT_EQ(jsonLineOf(text, "/" + name), 2);
    EXPECT_EQ(jsonLineOf(text, "/" + name + "/100000/b"), 3);
    EXPECT_EQ(jsonLineOf(text, "/" + name + "/100000/b/2"), 5);
    EXPECT_EQ(jsonLineOf(text, "/" + name + "/100001"), 0);
    EXPECT_EQ(jsonLineOf(text, ""), 1);
}

TEST(JsonLines, TellsPlacesApartThatBeginAlike) {
    const std::string text = "{\n\"a\": 1,\n\"ab\": {\n\"c\": 1,\n\"cd\": [\n1]}}";
    EXPECT_EQ(jsonLineOf(text, "/a"), 2);
    EXPECT_EQ(jsonLineOf(text, "/ab"), 3);
    EXPECT_EQ(jsonLineOf(text, "/ab/cd"), 5);
    EXPECT_EQ(jsonLineOf(text, "/ab/cd/0"), 6);
    EXPECT_EQ(jsonLineOf(text, "/a/c"), 0);
    EXPECT_EQ(jsonLineOf(text, "/abc"), 0);
}

}  // namespace
}  // namespace ticker
