#include <student_template/framework/app/Preview.h>
#include <tools/terminal_picture/TerminalPicture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace raytracer {
namespace {

/// Left half red, right half blue with a green edge below.
ByteImage flag(int width, int height) {
    ByteImage picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool left = x < width / 2;
            const bool low = y >= height - height / 4;
            for (const bool on : {left, low, !left})
                picture.rgb.push_back(on ? 215 : 0);
        }
    return picture;
}

TEST(Preview, TakesTheColoursThatTheEnvironmentOffers) {
    EXPECT_EQ(paletteFor("truecolor", "xterm-256color", ""), Palette::fullColour);
    EXPECT_EQ(paletteFor("24bit", "screen", ""), Palette::fullColour);
    EXPECT_EQ(paletteFor("", "xterm-direct", ""), Palette::fullColour);
    EXPECT_EQ(paletteFor("", "xterm-256color", ""), Palette::colours256);
    EXPECT_EQ(paletteFor("", "vt100", ""), Palette::text);
    EXPECT_EQ(paletteFor("truecolor", "dumb", ""), Palette::text);
    EXPECT_EQ(paletteFor("truecolor", "xterm-256color", "1"), Palette::text);
}

TEST(Preview, ShowsASmallPicturePixelForPixel) {
    for (const Palette palette : {Palette::fullColour, Palette::colours256}) {
        const ByteImage picture = flag(20, 12);
        Preview preview{{palette, true, 80, 24}};
        const ByteImage shown = ticker::terminalPicture(preview.frame(picture));

        EXPECT_EQ(shown.width, 20);
        EXPECT_EQ(shown.height, 12);
        EXPECT_EQ(shown.rgb, picture.rgb);
    }
}

TEST(Preview, FitsIntoTheTerminalWithItsShape) {
    Preview preview{{Palette::fullColour, true, 41, 12}};
    const ByteImage shown = ticker::terminalPicture(preview.frame(flag(640, 480)));

    EXPECT_LE(shown.width, 40);
    EXPECT_LE(shown.height, 20);
    EXPECT_NEAR(shown.width * 480.0 / 640.0, shown.height, 1.0);
}

TEST(Preview, DrawsTheNextFrameOverTheLast) {
    Preview preview{{Palette::fullColour, true, 80, 24}};
    const std::string first = preview.frame(ByteImage{20, 12, std::vector<std::uint8_t>(720)});
    const ByteImage shown = ticker::terminalPicture(first + preview.frame(flag(20, 12)));

    EXPECT_EQ(shown.rgb, flag(20, 12).rgb);
}

TEST(Preview, FindsTheNearestOfThe256Colours) {
    ByteImage picture{16, 16, {}};
    for (int i = 0; i < 256; ++i)
        for (const int byte : {i, i / 2, 255 - i})
            picture.rgb.push_back(static_cast<std::uint8_t>(byte));
    Preview preview{{Palette::colours256, true, 80, 24}};
    const ByteImage shown = ticker::terminalPicture(preview.frame(picture));

    ASSERT_EQ(shown.rgb.size(), picture.rgb.size());
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        ASSERT_NEAR(shown.rgb[i], picture.rgb[i], 48)
            << "byte " << i;  // half the cube's first step
}

TEST(Preview, WritesLettersWithoutEscapeCodesWhereThereIsNoTerminal) {
    Preview preview{{Palette::text, false, 80, 24}};
    const std::string text = preview.frame(flag(20, 12));

    EXPECT_EQ(text.find('\033'), std::string::npos);
    EXPECT_EQ(std::ranges::count(text, '\n'), 6);
    EXPECT_NE(text.front(), text[19]) << "red and blue differ in brightness";
}

}  // namespace
}  // namespace raytracer
