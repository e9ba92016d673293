#include <grader/lab/selftest/PictureTricks.h>
#include <grader/tasks/screenshot/Edits.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>

namespace ticker::tasks::screenshot {
namespace {

using metrics::Box;
using metrics::Mirror;

const Picture& photo() {
    static const Picture picture = selftest::photograph(320, 240, 7);
    return picture;
}

/// A scene whose own render is the photograph.
Scene scene() {
    Scene scene;
    scene.own = photo().view();
    return scene;
}

OwnWindows windowsOf(bool isDeterministic) {
    const Windows windows = drawWindows(isDeterministic, 320, 240, 3);
    return {windows, cutOut(photo().view(), windows), false};
}

Picture painted(const Box& box) {
    Picture picture = photo();
    for (int y = box.y; y < box.y + box.height; ++y)
        for (int x = 3 * box.x; x < 3 * (box.x + box.width); ++x) {
            std::uint8_t& byte = picture.rgb[static_cast<std::size_t>(y * 960 + x)];
            byte = static_cast<std::uint8_t>(byte + 128);
        }
    return picture;
}

TEST(AgreeingWindows, CountsEachByItself) {
    const OwnWindows own = windowsOf(false);
    const int all = static_cast<int>(own.windows.boxes.size());
    EXPECT_EQ(agreeingWindows(photo().view(), own), all);
    EXPECT_EQ(agreeingWindows(painted(own.windows.boxes[5]).view(), own), all - 1);
    EXPECT_EQ(agreeingWindows(painted(own.windows.boxes[0]).view(), own), all - 1);
    EXPECT_EQ(agreeingWindows(selftest::photograph(320, 240, 8).view(), own), 0);
}

TEST(FindShift, SaysWhereThePictureLies) {
    Picture rough = photo();
    std::uint32_t state = 1;
    for (std::uint8_t& byte : rough.rgb)
        byte = static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24U);
    OwnWindows own = windowsOf(true);
    own.pixels = cutOut(rough.view(), own.windows);
    const auto find = [&](int right, int down) {
        return findShift(selftest::moved(rough.view(), right, down).view(), own);
    };
    for (const auto& [right, down] : {std::pair{2, -1}, {0, 1}, {-3, 3}, {1, 0}}) {
        const auto shift = find(right, down);
        ASSERT_TRUE(shift) << right;
        EXPECT_EQ(shift->right, right);
        EXPECT_EQ(shift->down, down);
    }
    EXPECT_FALSE(find(0, 0)) << "where it should be";
    EXPECT_FALSE(find(4, 0)) << "too far";
    EXPECT_FALSE(find(0, -4));
}

TEST(FindShift, TakesTheShortest) {
    const Picture flat{320, 240, std::vector<std::uint8_t>(std::size_t{3} * 320 * 240, 90)};
    OwnWindows own = windowsOf(true);
    own.pixels = cutOut(flat.view(), own.windows);
    const auto shift = findShift(flat.view(), own);
    ASSERT_TRUE(shift);
    EXPECT_EQ(shift->right * shift->right + shift->down * shift->down, 1);
}

TEST(FindMirror, KnowsAllThreeFromNearAndFar) {
    const OwnWindows own = windowsOf(true);
    for (const Mirror mirror : {Mirror::leftRight, Mirror::upDown, Mirror::both})
        for (const OwnWindows* known : {&own, static_cast<const OwnWindows*>(nullptr)})
            EXPECT_EQ(findMirror(metrics::mirrored(photo().view(), mirror).view(), scene(), known),
                      mirror);
    EXPECT_FALSE(findMirror(photo().view(), scene(), nullptr));
    EXPECT_FALSE(findMirror(selftest::photograph(320, 240, 8).view(), scene(), &own));
}

std::string wordsFor(const Picture& picture) {
    const auto change = findRecolouring(picture.view(), scene());
    return change ? change->words : "";
}

TEST(FindRecolouring, SaysInWordsWhatWasDone) {
    EXPECT_EQ(wordsFor(selftest::inGrey(photo().view())), "it has no colours");
    EXPECT_EQ(wordsFor(selftest::withRedForBlue(photo().view())), "red and blue are exchanged");
    EXPECT_EQ(wordsFor(selftest::recoloured(photo().view(), [](double v, int) { return 1.0 - v; })),
              "it is a negative");
    EXPECT_EQ(wordsFor(selftest::recoloured(photo().view(), [](double v, int) { return 0.7 * v; })),
              "its colours or its brightness were changed");
    // Grey but for the red channel, which has half of the contrast.
    Picture almost = selftest::inGrey(photo().view());
    for (std::size_t i = 0; i < almost.rgb.size(); i += 3)
        almost.rgb[i] = static_cast<std::uint8_t>(almost.rgb[i] / 2 + 100);
    EXPECT_EQ(wordsFor(almost), "its colours or its brightness were changed");
    EXPECT_EQ(wordsFor(selftest::photograph(320, 240, 8)), "") << "another picture";
}

TEST(FindRecolouring, IsNoneWhereOnePlaceOrTheDetailIsAnother) {
    EXPECT_EQ(wordsFor(painted({100, 80, 20, 15})), "") << "one place";
    Picture checked =
        selftest::recoloured(photo().view(), [](double v, int) { return 0.6 * v + 0.2; });
    for (std::size_t i = 0; i < checked.rgb.size(); ++i) {
        const std::size_t x = i / 3 % 320;
        const std::size_t y = i / 960;
        const int by = (x / 4 + y / 4) % 2 == 0 ? 25 : -25;
        checked.rgb[i] = static_cast<std::uint8_t>(checked.rgb[i] + by);
    }
    EXPECT_EQ(wordsFor(checked), "") << "finer than a tile";
}

TEST(FindRecolouring, IsSlightUpToEightSteps) {
    const auto brighter = [](int steps) {
        Picture picture = photo();
        for (std::uint8_t& byte : picture.rgb)
            byte = static_cast<std::uint8_t>(byte < 255 - steps ? byte + steps : 255);
        return findRecolouring(picture.view(), scene());
    };
    ASSERT_TRUE(brighter(7));
    EXPECT_TRUE(brighter(7)->isSlight());
    EXPECT_NEAR(brighter(7)->distance, 6.2, 0.4) << "less where it is white already";
    EXPECT_FALSE(brighter(10)->isSlight());
}

TEST(FindCut, FindsTheSceneInAWindow) {
    const auto cut = findCut(selftest::inAWindow(photo().view(), 400, 300).view(), scene());
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->kind, Cut::Kind::framed);
    EXPECT_TRUE(cut->share > 0.4 && cut->share < 0.9) << cut->share;
    EXPECT_GT(cut->fit.correlation, 0.95);
}

TEST(FindCut, FindsThePictureInTheScene) {
    const auto cut = findCut(metrics::cropped(photo().view(), {40, 30, 240, 180}).view(), scene());
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->kind, Cut::Kind::cropped);
    EXPECT_NEAR(cut->share, 0.5625, 0.04);
    EXPECT_NEAR(cut->fit.box.x, 30, 3) << "of 240";
    EXPECT_NEAR(cut->fit.box.y, 22, 3);
}

TEST(FindCut, KnowsAnotherShape) {
    const auto cut = findCut(metrics::cropped(photo().view(), {0, 30, 320, 180}).view(), scene());
    ASSERT_TRUE(cut);
    EXPECT_EQ(cut->kind, Cut::Kind::otherShape);
    const auto above = findCut(metrics::cropped(photo().view(), {0, 0, 320, 180}).view(), scene());
    ASSERT_TRUE(above);
    EXPECT_EQ(above->kind, Cut::Kind::cropped) << "the foot is missing";
}

TEST(FindCut, FindsNothingInTheSceneItselfOrInAnother) {
    EXPECT_FALSE(findCut(photo().view(), scene()));
    EXPECT_FALSE(findCut(metrics::cropped(photo().view(), {2, 1, 316, 237}).view(), scene()));
    EXPECT_FALSE(findCut(selftest::photograph(320, 240, 8).view(), scene()));
}

// Scaled to the width of a search, it would take gigabytes and minutes.
TEST(FindCut, LooksForNothingInAStrip) {
    EXPECT_FALSE(findCut(selftest::photograph(1, 16'384, 8).view(), scene()));
    EXPECT_FALSE(findCut(selftest::photograph(16'384, 1, 8).view(), scene()));
}

}  // namespace
}  // namespace ticker::tasks::screenshot
