#include <grader/picture/DecodePicture.h>
#include <grader/pipeline/Screenshot.h>
#include <grader/tests/io/PngBuilder.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::pipeline {
namespace {

using tests::readFile;
using ticker::testing::equalRows;
using ticker::testing::makePng;
using ticker::testing::makePngAround;
using ticker::testing::pngChunk;
using ticker::testing::PngColour;

constexpr std::size_t kAfterHeader = 33;

std::string goodPicture() {
    return readFile("grader/corpus/samples/awarded/reference-bump/screenshot.png");
}

/// Judges the file only: the grader has no scenes.
TaskReport judge(const std::optional<std::string>& bytes, SubmissionResult& result) {
    build::TimeBudget budget{tests::testGrader().policy.submission};
    return judgeScreenshotFile(beginDecoding(bytes, tests::testGrader()), {}, tests::testGrader(),
                               budget, 1, result);
}

TaskReport judge(const std::optional<std::string>& bytes) {
    SubmissionResult unused;
    return judge(bytes, unused);
}

void expectUnreadable(const std::string& bytes, const std::string& why) {
    SubmissionResult result;
    const TaskReport report = judge(bytes, result);
    EXPECT_EQ(report.state, TaskState::failed) << why;
    ASSERT_EQ(report.findings.size(), 1U) << why;
    EXPECT_EQ(report.findings[0].id, "screenshot.unreadable");
    EXPECT_NE(report.findings[0].message.find(why), std::string::npos)
        << report.findings[0].message;
    EXPECT_TRUE(result.pictures.empty()) << why;
}

TEST(ScreenshotFile, SaysThatThereIsNone) {
    const TaskReport report = judge(std::nullopt);
    EXPECT_EQ(report.state, TaskState::failed);
    ASSERT_EQ(report.findings.size(), 1U);
    EXPECT_EQ(report.findings[0].id, "screenshot.missing");
}

TEST(ScreenshotFile, SaysWhyItCannotBeRead) {
    const std::string good = goodPicture();
    expectUnreadable(good.substr(0, good.size() / 2), "ends too early");
    expectUnreadable("\xFF\xD8\xFF\xE0 JFIF", "JPEG");
    expectUnreadable("a text", "no picture");
    std::string giant = good;
    giant.replace(16, 8, std::string{"\0\0\xFF\xFF\0\0\xFF\xFF", 8});
    expectUnreadable(giant, "65535 x 65535");
    std::string animated = good;
    animated.insert(kAfterHeader, pngChunk("acTL", std::string("\0\0\0\2\0\0\0\0", 8)));
    expectUnreadable(animated, "animated");
    std::string damaged = good;
    damaged[good.size() / 2] = static_cast<char>(damaged[good.size() / 2] ^ 1);
    expectUnreadable(damaged, "damaged");
}

TEST(ScreenshotFile, IsShownDecodedAndPackedAnew) {
    SubmissionResult result;
    std::string withText = goodPicture();
    withText.insert(kAfterHeader, pngChunk("tEXt", "Comment: <script>"));
    EXPECT_TRUE(isNotChecked(judge(withText, result)));
    ASSERT_EQ(result.pictures.size(), 1U);
    EXPECT_EQ(result.pictures[0].file, "images/screenshot.png");
    EXPECT_EQ(result.pictures[0].png.find("<script>"), std::string::npos);
}

TEST(ScreenshotFile, MayBeGreyAndLargeAndIsThenShownSmaller) {
    SubmissionResult result;
    const std::string large =
        makePng({2000, 1500, 8, PngColour::grey}, std::string(1500 * 2001, '\0'));
    EXPECT_TRUE(isNotChecked(judge(large, result)));
    ASSERT_EQ(result.pictures.size(), 1U);
    EXPECT_EQ(picture::claimedSize(result.pictures[0].png), (picture::PictureSize{1280, 960}));
}

TEST(ScreenshotFile, OfAnotherShapeOrTooSmallHasTheWrongSize) {
    for (const auto& [width, height] : {std::pair{640U, 400U}, std::pair{160U, 120U}}) {
        const TaskReport report = judge(
            makePng({width, height, 8, PngColour::grey}, std::string(height * (width + 1), '\0')));
        ASSERT_EQ(report.findings.size(), 1U);
        EXPECT_EQ(report.findings[0].id, "screenshot.wrong-size");
    }
}

}  // namespace
}  // namespace ticker::pipeline
