#include <grader/session/Highlight.h>

#include <gtest/gtest.h>

namespace ticker::session {
namespace {

bool has(const std::string& html, const std::string& part) {
    return html.find(part) != std::string::npos;
}

TEST(Highlight, ColoursWhatCppConsistsOf) {
    const std::string html = highlightCpp(
        "#include <cmath>\n// TASK T1 begin\nconst double x = 2.5e-7; // why\n\"a\\\"b\"; '\\''; "
        "x1");
    EXPECT_TRUE(has(html, "<i class=\"p\">#include &lt;cmath&gt;</i>")) << html;
    EXPECT_TRUE(has(html, "<i class=\"m\">// TASK T1 begin</i>")) << html;
    EXPECT_TRUE(has(html, "<i class=\"k\">const</i> <i class=\"k\">double</i> x")) << html;
    EXPECT_TRUE(has(html, "<i class=\"n\">2.5e-7</i>;")) << html;
    EXPECT_TRUE(has(html, "<i class=\"c\">// why</i>")) << html;
    EXPECT_TRUE(has(html, "<i class=\"s\">&quot;a\\&quot;b&quot;</i>;")) << html;
    EXPECT_TRUE(has(html, "</i>; x1</span>")) << html;
}

TEST(Highlight, KeepsLinesWholeAcrossLongTokens) {
    EXPECT_EQ(highlightCpp("/*a\nb*/c\n"),
              "<span class=\"line\"><i class=\"c\">/*a</i></span>\n"
              "<span class=\"line\"><i class=\"c\">b*/</i>c</span>");
    EXPECT_TRUE(has(highlightCpp("R\"x(1\n)\" 2)x\" int"),
                    "<i class=\"s\">)&quot; 2)x&quot;</i> "
                    "<i class=\"k\">int</i>"));
}

TEST(Highlight, EscapesEverythingWhereverItStands) {
    for (const char* source :
         {"<script>alert(1)</script>", "// <script>", "\"<script>", "/*<script>", "R\"(<script>",
          "#<script>", "'<script>'", "1<script>"}) {
        const std::string html = highlightCpp(source);
        EXPECT_FALSE(has(html, "<script")) << html;
        EXPECT_TRUE(has(html, "&lt;script")) << html;
    }
}

TEST(Highlight, SurvivesAnyBytes) {
    std::string bytes;
    unsigned state = 7;
    for (int i = 0; i < 20000; ++i) {
        state = 1664525U * state + 1013904223U;
        bytes += static_cast<char>(state >> 24U);
        if (i % 5 == 0) bytes += "R\"('\"/*#\n";
    }
    EXPECT_GT(highlightCpp(bytes).size(), bytes.size());
    EXPECT_EQ(highlightCpp(""), "<span class=\"line\"></span>");
}

}  // namespace
}  // namespace ticker::session
