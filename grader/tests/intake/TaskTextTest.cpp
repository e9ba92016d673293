#include <grader/intake/TaskText.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

namespace ticker::intake {
namespace {

std::string between(const std::string& body) {
    return "int before;\n// TASK T1 begin\n" + body + "\n// TASK T1 end\nint after;\n";
}

TEST(TaskText, HasNeitherCommentsNorWhiteSpace) {
    EXPECT_EQ(taskText(between("return  x; // why\n\t/* a\n b */ y = 'a' ;"), "T1"),
              "returnx;y='a';");
}

TEST(TaskText, KeepsLiteralsAsTheyAre) {
    EXPECT_EQ(taskText(between("f(\"a // b /* c\\\" d\", '\\'', '\"');"), "T1"),
              "f(\"a // b /* c\\\" d\",'\\'','\"');");
    EXPECT_EQ(taskText(between("f(R\"x(a \" // )\" b)x\", 1 );"), "T1"),
              "f(R\"x(a \" // )\" b)x\",1);");
    EXPECT_EQ(taskText(between("f(u8R\"(a // b)\" );"), "T1"), "f(u8R\"(a // b)\");");
    EXPECT_EQ(taskText(between("f(1'000, 0xA'B, u8'x' , ' ');"), "T1"),
              "f(1'000,0xA'B,u8'x',' ');");
    EXPECT_EQ(taskText(between("case' ': f(x1, .5e1'0, 0xAB'CD'EF , ' ');"), "T1"),
              "case' ':f(x1,.5e1'0,0xAB'CD'EF,' ');");
}

TEST(TaskText, SeesNoMarkInsideALiteralOrABlockComment) {
    const std::string source =
        "const char* a = \"// TASK T1 begin\";\n/* // TASK T1 begin\n */\n" + between("x");
    EXPECT_EQ(taskText(source, "T1"), "x");
}

TEST(TaskText, GoesOnOverASplicedCommentLine) {
    EXPECT_EQ(taskText(between("// comment \\\nstill a comment\nx"), "T1"), "x");
}

TEST(TaskText, IsEmptyWithoutBothMarks) {
    EXPECT_EQ(taskText("x", "T1"), std::nullopt);
    EXPECT_EQ(taskText("// TASK T1 begin\nx", "T1"), std::nullopt);
    EXPECT_EQ(taskText(between("x"), "T2.1"), std::nullopt);
    EXPECT_EQ(taskText("", "T1"), std::nullopt);
}

TEST(HoldsCode, SeesNoneInAMarkWhiteSpaceAndComments) {
    for (const char* source : {"", "\xEF\xBB\xBF", " \t\r\n\f", "// TASK T1 begin", "/**/",
                               "\xEF\xBB\xBF// a\n/* b\n */\r\n"})
        EXPECT_FALSE(holdsCode(source)) << source;
    for (const char* source : {"x", "#include <cmath>\n", "// a\nx", "/* a */ ;", "\"//\"",
                               "/* never ends\nint x;", "/*/", "\xEF\xBB"})
        EXPECT_TRUE(holdsCode(source)) << source;
}

TEST(IsStub, KnowsTheTemplateWhateverTheLayout) {
    const std::string handedOut = between("unfinished(\"T1\", \"a b\");\nreturn n;");
    EXPECT_TRUE(isStub(between("  unfinished( \"T1\",\t\"a b\" );  // todo\r\n  return n;\r\n"),
                       handedOut, "T1"));
    EXPECT_FALSE(isStub(between("unfinished(\"T1\", \"ab\");\nreturn n;"), handedOut, "T1"));
    EXPECT_FALSE(isStub(between("return n;"), handedOut, "T1"));
    EXPECT_FALSE(isStub("unfinished(\"T1\", \"a b\");\nreturn n;", handedOut, "T1"));
}

TEST(IsStub, TellsTheThreeTasksOfTheRealFilesApart) {
    const auto stub = tests::readFile("student_template/exercise/Renderer.cpp");
    const auto solved = tests::readFile("reference_solution/exercise/Renderer.cpp");
    for (const char* task : {"T2.1", "T2.2"}) {
        EXPECT_TRUE(isStub(stub, stub, task)) << task;
        EXPECT_FALSE(isStub(solved, stub, task)) << task;
    }
    const auto bump = tests::readFile("student_template/exercise/BumpySphere.cpp");
    EXPECT_TRUE(isStub(bump, bump, "T1"));
    EXPECT_FALSE(
        isStub(tests::readFile("reference_solution/exercise/BumpySphere.cpp"), bump, "T1"));
}

}  // namespace
}  // namespace ticker::intake
