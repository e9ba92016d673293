#include <grader/tasks/screenshot/Windows.h>

#include <gtest/gtest.h>

#include <array>

namespace ticker::tasks::screenshot {
namespace {

constexpr std::array kWidths{320, 640, 800, 1280, 4096};

bool overlap(const metrics::Box& a, const metrics::Box& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

TEST(SensibleSize, IsTheHandoutsShapeFrom320Upwards) {
    for (const int width : kWidths)
        EXPECT_TRUE(isSensibleSize(width, width * 3 / 4)) << width;
    EXPECT_TRUE(isSensibleSize(1366, 1024)) << "rounded";
    EXPECT_TRUE(isSensibleSize(4096, 3072));
    EXPECT_FALSE(isSensibleSize(4400, 3300)) << "the probe draws no such frame";
    EXPECT_FALSE(isSensibleSize(640, 400));
    EXPECT_FALSE(isSensibleSize(480, 640));
    EXPECT_FALSE(isSensibleSize(300, 225));
}

TEST(Windows, AreAFewThousandPixelsInsideTheFrameWithRoomToShift) {
    for (const bool isDeterministic : {true, false})
        for (const int width : kWidths)
            for (std::uint64_t seed = 0; seed < 50; ++seed) {
                int pixels = 0;
                for (const metrics::Box& box :
                     drawWindows(isDeterministic, width, width * 3 / 4, seed).boxes) {
                    EXPECT_GE(box.x, kFarthestShift);
                    EXPECT_GE(box.y, kFarthestShift);
                    EXPECT_LE(box.x + box.width, width - kFarthestShift);
                    EXPECT_LE(box.y + box.height, width * 3 / 4 - kFarthestShift);
                    pixels += box.width * box.height;
                }
                const bool isNarrow = !isDeterministic && width < 480;
                EXPECT_NEAR(pixels, isNarrow ? 3456 : 2300, 300);
            }
}

// The tail bound requires that no pixel counts twice, and that the second stage uses other pixels.
TEST(Windows, HaveNoPixelTwice) {
    for (const int width : kWidths)
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            std::vector<metrics::Box> boxes = drawWindows(false, width, width * 3 / 4, seed).boxes;
            for (std::size_t i = 0; i < boxes.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(overlap(boxes[i], boxes[j])) << width << " " << i << " " << j;
            const std::vector<metrics::Box> later =
                drawWindows(false, width, width * 3 / 4, seed, 1).boxes;
            for (std::size_t i = 0; i < boxes.size(); ++i)
                for (std::size_t j = 0; j < later.size(); ++j)
                    if (i == j || width < 480) {
                        EXPECT_FALSE(overlap(boxes[i], later[j])) << width << " " << i << " " << j;
                    }
        }
}

TEST(Windows, MoveFromSeedToSeedAndStayUnderASeed) {
    const Windows first = drawWindows(false, 640, 480, 1);
    EXPECT_EQ(first.boxes, drawWindows(false, 640, 480, 1).boxes);
    EXPECT_NE(first.boxes, drawWindows(false, 640, 480, 2).boxes);
}

TEST(CutOut, PutsWindowsOneBelowTheOtherAndCanLookBeside) {
    Picture picture{4, 3, {}};
    for (std::uint8_t i = 0; i < 12; ++i)
        picture.rgb.insert(picture.rgb.end(), 3, i);
    const Windows windows{4, 3, {{0, 0, 2, 1}, {1, 1, 2, 1}}};
    const auto reds = [](const Picture& p) {
        return std::vector<int>{p.rgb[0], p.rgb[3], p.rgb[6], p.rgb[9]};
    };
    const Picture strip = cutOut(picture.view(), windows);
    EXPECT_EQ(strip.width, 2);
    EXPECT_EQ(strip.height, 2);
    EXPECT_EQ(reds(strip), (std::vector{0, 1, 5, 6}));
    EXPECT_EQ(reds(cutOut(picture.view(), windows, 1, 1)), (std::vector{5, 6, 10, 11}));
}

}  // namespace
}  // namespace ticker::tasks::screenshot
