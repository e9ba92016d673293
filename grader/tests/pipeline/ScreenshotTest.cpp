#include <grader/pipeline/Screenshot.h>
#include <grader/tests/io/PngBuilder.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <random>

namespace ticker::pipeline {
namespace {

// Any whole PNG of the project will do; this one is not of the handout's size.
std::string somePng() {
    return tests::readFile("assets/bumpmap-test.png");
}

TEST(PngHeader, KnowsTheSizeOfAWholeFile) {
    const auto header = readPngHeader(somePng());
    ASSERT_TRUE(header);
    EXPECT_GE(header->width, 1024);
    EXPECT_GE(header->height, 512);
}

TEST(PngHeader, IsEmptyForAFileThatWasCut) {
    const std::string bytes = somePng();
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{7}, std::size_t{20}, bytes.size() / 2, bytes.size() - 1})
        EXPECT_FALSE(readPngHeader(std::string_view{bytes}.substr(0, size))) << size;
}

TEST(PngHeader, IsEmptyForAnotherFormatAndForDamage) {
    EXPECT_FALSE(readPngHeader("\xFF\xD8\xFF\xE0 JFIF"));
    std::string bytes = somePng();
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    EXPECT_FALSE(readPngHeader(bytes)) << "a check sum is wrong";
}

TEST(PngHeader, RefusesGiantSizesBeforeAnybodyTakesMemory) {
    // IHDR of 65535 x 65535 with a right check sum, made by hand.
    std::string bytes = somePng();
    bytes[16] = bytes[17] = bytes[20] = bytes[21] = 0;
    bytes[18] = bytes[19] = bytes[22] = bytes[23] = static_cast<char>(0xFF);
    EXPECT_FALSE(readPngHeader(bytes));
}

TEST(PngHeader, SurvivesAnyBytes) {
    std::mt19937 generator{4};
    const std::string bytes = somePng().substr(0, 200);
    for (int round = 0; round < 2000; ++round) {
        std::string damaged = bytes;
        for (int i = 0; i < 4; ++i)
            damaged[8 + generator() % 192] = static_cast<char>(generator() & 0xFFU);
        static_cast<void>(readPngHeader(damaged));
    }
}

TEST(JudgeScreenshotFile, NamesWhatIsWrong) {
    EXPECT_EQ(judgeScreenshotFile({}).findings.at(0).id, "screenshot.missing");
    EXPECT_EQ(judgeScreenshotFile("text").findings.at(0).id, "screenshot.unreadable");
    const TaskReport report = judgeScreenshotFile(somePng());
    EXPECT_EQ(report.state, TaskState::failed);
    EXPECT_EQ(report.findings.at(0).id, "screenshot.wrong-size");
}

TEST(JudgeScreenshotFile, TakesAPictureOfTheHandoutsSize) {
    const TaskReport report = judgeScreenshotFile(
        tests::readFile("grader/samples/awarded/reference-bump/screenshot.png"));
    EXPECT_EQ(report.state, TaskState::passed);
    EXPECT_TRUE(report.findings.empty());
}

// 640 x 480, three bytes for each pixel, so many bytes in all.
std::string pictureOf(std::size_t bytes, bool interlaced = false) {
    return ticker::testing::makePng({640, 480, 8, ticker::testing::PngColour::rgb, interlaced},
                                    std::string(bytes, '\0'));
}

constexpr std::size_t kAllRows = 480 * (1 + 640 * 3);

TEST(JudgeScreenshotFile, RefusesMoreOrFewerPixelsThanItsSizeTells) {
    EXPECT_EQ(judgeScreenshotFile(pictureOf(kAllRows)).state, TaskState::passed);
    for (const std::size_t bytes : {kAllRows - 1, kAllRows + 1, 8 * kAllRows, std::size_t{0}}) {
        const TaskReport report = judgeScreenshotFile(pictureOf(bytes));
        ASSERT_EQ(report.findings.size(), 1U) << bytes;
        EXPECT_EQ(report.findings[0].id, "screenshot.unreadable") << bytes;
    }
}

// Adam7: 900 rows in seven passes, each with its filter byte.
TEST(JudgeScreenshotFile, KnowsInterlacedPictures) {
    constexpr std::size_t kAllPasses = 640 * 480 * 3 + 900;
    EXPECT_EQ(judgeScreenshotFile(pictureOf(kAllPasses, true)).state, TaskState::passed);
    EXPECT_EQ(judgeScreenshotFile(pictureOf(kAllRows, true)).state, TaskState::failed);
}

}  // namespace
}  // namespace ticker::pipeline
