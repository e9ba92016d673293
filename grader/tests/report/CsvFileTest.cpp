#include <grader/report/platforms/CsvFile.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

namespace ticker::report {
namespace {

std::string errorOf(const std::string& text) {
    try {
        const CsvFile file{text, "sheet.csv"};
        return "";
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
}

TEST(CsvFile, UntouchedFieldsComeOutByteForByte) {
    const std::string text =
        "\xEF\xBB\xBFIdentifier,\"Full name\",Grade\r\n"
        "\"Participant 1\",\"O\"\"Neill, Z\xC3\xB6\",\r\n"
        "Participant 2,\"two\nlines\",\"5\"\n"
        "Participant 3,,";
    CsvFile file{text, "sheet.csv"};
    EXPECT_EQ(file.text(), text);
    file.set(2, 2, "7 \"of\" 9");
    EXPECT_EQ(file.text().substr(0, 80), text.substr(0, 80));
    EXPECT_EQ(file.value(2, 2), "7 \"of\" 9");
    EXPECT_EQ(file.value(2, 1), "two\nlines");
}

TEST(CsvFile, ReadsFieldsWithoutTheirQuotes) {
    const CsvFile file{"a,\"b\"\"c\",\"d,e\",\"\",f\"g\n", "sheet.csv"};
    EXPECT_EQ(file.columns(), 5U);
    EXPECT_EQ(file.value(0, 1), "b\"c");
    EXPECT_EQ(file.value(0, 2), "d,e");
    EXPECT_EQ(file.value(0, 3), "");
    EXPECT_EQ(file.value(0, 4), "f\"g");
}

TEST(CsvFile, AQuoteAfterABackslashDoesNotEndAFieldAsInPhp) {
    const CsvFile file{"\"a \\\" , b\",c\n", "sheet.csv"};
    EXPECT_EQ(file.columns(), 2U);
    EXPECT_EQ(file.value(0, 0), "a \\\" , b");
}

TEST(CsvFile, SaysInWhichLineAFileIsBroken) {
    EXPECT_NE(errorOf("").find("empty"), std::string::npos);
    EXPECT_NE(errorOf("a,b\n\"1\n2\",3\n4\n").find("sheet.csv:4: 1 fields"), std::string::npos)
        << errorOf("a,b\n\"1\n2\",3\n4\n");
    EXPECT_NE(errorOf("a,b\n1,\"2\n").find("sheet.csv:2"), std::string::npos);
    EXPECT_NE(errorOf("a,b\n1,\"2\\\"").find("never ends"), std::string::npos);
}

}  // namespace
}  // namespace ticker::report
