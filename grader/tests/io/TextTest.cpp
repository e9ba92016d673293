#include <raytracer/base/Text.h>

#include <gtest/gtest.h>

#include <array>
#include <string_view>

namespace raytracer {
namespace {

TEST(ParseNumber, ReadsWhatPeopleWrite) {
    EXPECT_EQ(parseNumber("3.51805"), 3.51805);
    EXPECT_EQ(parseNumber("-0.26398"), -0.26398);
    EXPECT_EQ(parseNumber("+2"), 2.0);
    EXPECT_EQ(parseNumber("1e-3"), 0.001);
    EXPECT_EQ(parseNumber(".5"), 0.5);
}

TEST(ParseNumber, RefusesWhatIsNoFiniteNumberThroughout) {
    for (const std::string_view text :
         {"", " 1", "1 ", "1,5", "1.5m", "nan", "inf", "-infinity", "1e999", "0x10", "+-1", "++1",
          "--1", "1..2", "e5", "+", "one"})
        EXPECT_FALSE(parseNumber(text)) << text;
}

TEST(ParseCount, ReadsOnlyDigits) {
    EXPECT_EQ(parseCount("18446744073709551615"), 18446744073709551615U);
    for (const std::string_view text : {"", "-1", "+1", "1.0", "18446744073709551616", " 1"})
        EXPECT_FALSE(parseCount(text)) << text;
}

TEST(InQuotes, KeepsMessagesOnOneReadableLine) {
    EXPECT_EQ(inQuotes("kD"), "\"kD\"");
    EXPECT_EQ(inQuotes("a\n\x1B[31m"), "\"a\\x0A\\x1B[31m\"");
    EXPECT_EQ(inQuotes("\xC3\xA9"), "\"\\xC3\\xA9\"");
    EXPECT_EQ(inQuotes(std::string(100, 'a')), "\"" + std::string(60, 'a') + "...\"");
}

TEST(NearestName, GuessesSlipsOfTheKeyAndOfCase) {
    constexpr auto kNames =
        std::to_array<std::string_view>({"x", "y", "colour", "kD", "kS", "reflectivity"});
    EXPECT_EQ(nearestName("color", kNames), "colour");
    EXPECT_EQ(nearestName("kd", kNames), "kD");
    EXPECT_EQ(nearestName("reflectvity", kNames), "reflectivity");
    EXPECT_EQ(nearestName("X", kNames), "x");
}

TEST(NearestName, DoesNotGuessWhereNothingIsNear) {
    constexpr auto kNames = std::to_array<std::string_view>({"x", "y", "colour"});
    EXPECT_FALSE(nearestName("w", kNames));
    EXPECT_FALSE(nearestName("transmittance", kNames));
    EXPECT_FALSE(nearestName("", kNames));
    EXPECT_FALSE(nearestName("x", {}));
}

}  // namespace
}  // namespace raytracer
