#include <grader/build/Diagnostics.h>

#include <gtest/gtest.h>

namespace ticker::build {
namespace {

TEST(Diagnostics, NameTheStudentsFileInsteadOfTheLinkersObject) {
    EXPECT_EQ(readableDiagnostics(">>> defined at /tmp/ccAb12xZ.o:(main)\n", {}, "Renderer.cpp"),
              ">>> defined at Renderer.cpp:(main)\n");
}

// The line number refers to the assembler code, not to the student's file.
TEST(Diagnostics, NameTheStudentsFileInsteadOfTheAssemblersAndNoLineOfIt) {
    EXPECT_EQ(readableDiagnostics("/tmp/ccAb12xZ.s: Assembler messages:\n"
                                  "/tmp/ccAb12xZ.s:7: Error: no such instruction: `x'\n",
                                  {}, "Renderer.cpp"),
              "Renderer.cpp (as assembler code): Assembler messages:\n"
              "Renderer.cpp (as assembler code):7: Error: no such instruction: `x'\n");
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
    EXPECT_EQ(readableDiagnostics("caf\xE9\n", {}, "a.cpp"), "caf\xEF\xBF\xBD\n");
}

}  // namespace
}  // namespace ticker::build
