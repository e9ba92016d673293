#include <grader/lab/selftest/PictureTricks.h>
#include <grader/tasks/screenshot/Whole.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::tasks::screenshot {
namespace {

const Picture& sceneOfBalls() {
    static const Picture picture = selftest::photograph(320, 240, 7);
    return picture;
}

TEST(Likeness, KnowsAPictureAtAnySizeAndBrightness) {
    const Picture small = metrics::resized(sceneOfBalls().view(), 400, 300);
    EXPECT_GT(likeness(sceneOfBalls().view(), small.view()), 0.99);
    const Picture dark =
        selftest::recoloured(sceneOfBalls().view(), [](double v, int) { return 0.4 * v; });
    EXPECT_GT(likeness(sceneOfBalls().view(), dark.view()), 0.99);
    EXPECT_LT(likeness(sceneOfBalls().view(), selftest::photograph(320, 240, 8).view()), 0.8);
}

TEST(TileDifference, SaysWhereAndHowMuch) {
    EXPECT_EQ(tileDifference(sceneOfBalls().view(), sceneOfBalls().view()).worst, 0.0);
    const TileDifference note =
        tileDifference(sceneOfBalls().view(), selftest::withANote(sceneOfBalls().view()).view());
    EXPECT_GT(note.worst, 20.0);
    EXPECT_NEAR(note.worstX, 0.875, 0.1);
    EXPECT_NEAR(note.worstY, 0.825, 0.1);
    EXPECT_LT(note.rms, note.worst);
}

TEST(ColourChange, IsFoundForGreyExchangedChannelsNegativesAndGamma) {
    const auto left = [](const Picture& changed) {
        const Picture again =
            ColourChange{sceneOfBalls().view(), changed.view()}.appliedTo(sceneOfBalls().view());
        return tileDifference(again.view(), changed.view()).rms;
    };
    EXPECT_LT(left(selftest::inGrey(sceneOfBalls().view())), 1.0);
    EXPECT_LT(left(selftest::withRedForBlue(sceneOfBalls().view())), 1.0);
    EXPECT_LT(
        left(selftest::recoloured(sceneOfBalls().view(), [](double v, int) { return 1.0 - v; })),
        1.0);
    EXPECT_LT(left(selftest::recoloured(sceneOfBalls().view(),
                                        [](double v, int) { return std::pow(v, 0.6); })),
              3.0);
    EXPECT_GT(left(selftest::photograph(320, 240, 8)), 10.0) << "another picture is no change";
}

}  // namespace
}  // namespace ticker::tasks::screenshot
