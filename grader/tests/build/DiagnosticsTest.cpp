#include <grader/build/Diagnostics.h>

#include <gtest/gtest.h>

namespace ticker::build {
namespace {

TEST(Diagnostics, NameTheStudentsFileInsteadOfTheLinkersObject) {
    EXPECT_EQ(readableDiagnostics(">>> defined at /tmp/ccAb12xZ.o:(main)\n", {}, "Renderer.cpp"),
              ">>> defined at Renderer.cpp:(main)\n");
}

TEST(Diagnostics, LoseTheFoldersOfThisMachine) {
    EXPECT_EQ(readableDiagnostics("/kit/include/raytracer/math/Ray.h:3: x\n/src/a.cpp:1: y\n",
                                  {"/src", "/kit"}, "a.cpp"),
              "raytracer/math/Ray.h:3: x\na.cpp:1: y\n");
}

TEST(Diagnostics, AreCutAtALineAndSaySo) {
    std::string output;
    for (int i = 0; i < 4000; ++i)
        output += "0123456789\n";
    const std::string text = readableDiagnostics(output, {}, "a.cpp");
    EXPECT_LE(text.size(), kMostDiagnostics + 40);
    EXPECT_TRUE(text.ends_with("0123456789\n(more was left out)\n"));
}

TEST(Diagnostics, AreValidUtf8) {
    const std::string replaced = "\xEF\xBF\xBD";
    EXPECT_EQ(asUtf8("caf\xC3\xA9 \xE2\x80\x98x\xE2\x80\x99"),
              "caf\xC3\xA9 \xE2\x80\x98x\xE2\x80\x99");
    EXPECT_EQ(asUtf8("caf\xE9!"), "caf" + replaced + "!");
    EXPECT_EQ(asUtf8("\xC0\xAF"), replaced + replaced);                 // overlong
    EXPECT_EQ(asUtf8("\xED\xA0\x80"), replaced + replaced + replaced);  // surrogate
    EXPECT_EQ(asUtf8("\xF0\x9F\x98"), replaced + replaced + replaced);  // cut
    EXPECT_EQ(asUtf8(std::string{"a\0b", 3}), "a" + replaced + "b");
}

}  // namespace
}  // namespace ticker::build
