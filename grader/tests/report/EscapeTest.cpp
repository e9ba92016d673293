#include <grader/report/Escape.h>

#include <gtest/gtest.h>

namespace ticker::report {
namespace {

TEST(EscapeHtml, LeavesNoWayOutOfTextOrAttribute) {
    EXPECT_EQ(escapeHtml("<script>alert('x')</script> & \"y\""),
              "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;y&quot;");
}

TEST(CleanText, KeepsUnicodeAndReplacesWhatIsNone) {
    EXPECT_EQ(cleanText("Zo\xC3\xAB \xE2\x82\xAC \xF0\x9F\x98\x80"),
              "Zo\xC3\xAB \xE2\x82\xAC \xF0\x9F\x98\x80");
    EXPECT_EQ(cleanText("a\xFFz"), "a\xEF\xBF\xBDz");
    EXPECT_EQ(cleanText("cut \xE2\x82"), "cut \xEF\xBF\xBD\xEF\xBF\xBD");
    EXPECT_EQ(cleanText("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
    EXPECT_EQ(cleanText("\xED\xA0\x80").substr(0, 3), "\xEF\xBF\xBD") << "surrogate";
}

TEST(CleanText, TakesControlOfTheTerminalAndOfTheReadingDirectionAway) {
    EXPECT_EQ(cleanText("\x1B[31mred"), "\xEF\xBF\xBD[31mred");
    EXPECT_EQ(cleanText("a\xE2\x80\xAE"
                        "b"),
              "a\xEF\xBF\xBD"
              "b");
    EXPECT_EQ(cleanText("one\r\ntwo\tthree"), "one\ntwo\tthree");
    EXPECT_EQ(cleanText(std::string_view{"a\0b", 3}),
              "a\xEF\xBF\xBD"
              "b");
}

TEST(EscapeCsv, QuotesWhereNeededAndDefusesFormulas) {
    EXPECT_EQ(escapeCsv("plain"), "plain");
    EXPECT_EQ(escapeCsv("a,b"), "\"a,b\"");
    EXPECT_EQ(escapeCsv("say \"hi\""), "\"say \"\"hi\"\"\"");
    EXPECT_EQ(escapeCsv("=cmd|' /C calc'!A0"), "'=cmd|' /C calc'!A0");
    EXPECT_EQ(escapeCsv("-1"), "'-1");
    EXPECT_EQ(escapeCsv("two\nlines"), "\"two\nlines\"");
}

TEST(EscapeLine, IsOneLine) {
    EXPECT_EQ(escapeLine("a\nb\tc"), "a b c");
}

}  // namespace
}  // namespace ticker::report
