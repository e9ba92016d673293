#include <student_template/framework/app/Canvas.h>

#include <gtest/gtest.h>

namespace raytracer {
namespace {

RenderSettings smallSettings() {
    RenderSettings settings;
    settings.width = 8;
    settings.height = 6;
    settings.threads = 2;
    return settings;
}

/// Sets all pixels, like a solution that does not use `forEachPixel`.
void setAllPixels(Canvas& canvas) {
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x)
            canvas.pixelSet(x, y, ColourRGB{1.0});
}

TEST(Canvas, KeepsWhatIsSetAndIsBlackElsewhere) {
    Canvas canvas{smallSettings(), [] { return false; }};
    canvas.pixelSet(3, 2, ColourRGB{0.25});

    EXPECT_EQ(canvas.picture().at(3, 2), ColourRGB{0.25});
    EXPECT_EQ(canvas.picture().at(2, 3), ColourRGB{});
    EXPECT_GT(canvas.bytes().rgb.at(3 * (2 * 8 + 3)), 0);
    EXPECT_NO_THROW(setAllPixels(canvas));
}

TEST(Canvas, StopsAPlainLoopThatGoesOnAfterAnInterrupt) {
    Canvas canvas{smallSettings(), [] { return true; }};

    EXPECT_THROW(setAllPixels(canvas), RenderStopped);
    EXPECT_EQ(canvas.picture().at(0, 0), ColourRGB{1.0});
    EXPECT_EQ(canvas.picture().at(7, 5), ColourRGB{});
}

TEST(Canvas, LetsTheRowsUnderWayFinishAfterAnInterrupt) {
    Canvas canvas{smallSettings(), [] { return true; }};

    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_NO_THROW(canvas.pixelSet(x, y, ColourRGB{1.0}));
}

}  // namespace
}  // namespace raytracer
