// The line that shows progress on a terminal.
#include <grader/cli/ProgressLine.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::cli {
namespace {

const std::string kClear = "\r\x1B[K";

TEST(ProgressLine, IsDrawnWholeWhereItFits) {
    EXPECT_EQ(drawnLine("[##..] 2/4", 11), kClear + "[##..] 2/4");
    EXPECT_EQ(drawnLine("[##..] 2/4", 80), kClear + "[##..] 2/4");
}

TEST(ProgressLine, IsCutBeforeTheLastColumnSoThatNothingWraps) {
    EXPECT_EQ(drawnLine("[##..] 2/4", 10), kClear + "[##..] 2/");
    EXPECT_EQ(drawnLine("[##..] 2/4", 2), kClear + "[");
    EXPECT_EQ(drawnLine("[##..] 2/4", 1), kClear);
}

TEST(ProgressLine, IsDrawnWholeWhereTheWidthIsNotKnown) {
    EXPECT_EQ(drawnLine("[##..] 2/4", 0), kClear + "[##..] 2/4");
}

}  // namespace
}  // namespace ticker::cli
