#include <grader/metrics/Alignment.h>

#include "MadePictures.h"

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <numeric>

namespace ticker::metrics {
namespace {

/// A picture without similar parts.
Picture landscape(int width, int height) {
    return makePicture(width, height, [&](int x, int y) {
        const double u = 1.0 * x / width;
        const double v = 1.0 * y / height;
        const int hill = static_cast<int>(90.0 + 80.0 * std::sin(7.0 * u * u + 3.0 * v));
        const int sky = static_cast<int>(80.0 * v);
        return Rgb{hill, hill / 2 + sky, 200 - hill};
    });
}

TEST(Resized, TakesTheMeanOfTheAreaThatAPixelCovers) {
    const Picture picture = makePicture(4, 2, [](int x, int y) { return Rgb{10 * x, 20 * y, 7}; });
    const Picture half = resized(picture.view(), 2, 1);
    EXPECT_EQ(half.width, 2);
    EXPECT_EQ(half.height, 1);
    EXPECT_EQ(half.rgb, (std::vector<std::uint8_t>{5, 10, 7, 25, 10, 7}));
}

TEST(Mirrored, ExchangesSides) {
    const Picture picture = makePicture(2, 2, [](int x, int y) { return Rgb{x + 2 * y, 0, 0}; });
    const auto reds = [](const Picture& p) {
        return std::vector<int>{p.rgb[0], p.rgb[3], p.rgb[6], p.rgb[9]};
    };
    EXPECT_EQ(reds(mirrored(picture.view(), Mirror::leftRight)), (std::vector{1, 0, 3, 2}));
    EXPECT_EQ(reds(mirrored(picture.view(), Mirror::upDown)), (std::vector{2, 3, 0, 1}));
    EXPECT_EQ(reds(mirrored(picture.view(), Mirror::both)), (std::vector{3, 2, 1, 0}));
}

TEST(Cropped, CutsThePartOutAndRefusesOneThatIsNotThere) {
    const Picture picture = makePicture(5, 4, [](int x, int y) { return Rgb{x, y, 0}; });
    const Picture part = cropped(picture.view(), {3, 1, 2, 2});
    EXPECT_EQ(part.rgb, (std::vector<std::uint8_t>{3, 1, 0, 4, 1, 0, 3, 2, 0, 4, 2, 0}));
    for (const Box& box : {Box{4, 0, 2, 2}, Box{0, 3, 2, 2}, Box{-1, 0, 2, 2}, Box{0, 0, 0, 2}})
        EXPECT_THROW((void)cropped(picture.view(), box), raytracer::InputError);
}

TEST(Correlation, KnowsNothingOfBrightnessAndContrast) {
    const Picture picture = landscape(80, 60);
    Picture pale = picture;
    Picture negative = picture;
    for (std::uint8_t& value : pale.rgb)
        value = static_cast<std::uint8_t>(100 + value / 2);
    for (std::uint8_t& value : negative.rgb)
        value = static_cast<std::uint8_t>(255 - value);
    EXPECT_NEAR(correlation(picture.view(), picture.view()), 1.0, 1e-5);
    EXPECT_GT(correlation(picture.view(), pale.view()), 0.999);
    EXPECT_LT(correlation(picture.view(), negative.view()), -0.999);
}

TEST(Correlation, OfAFlatPictureIsZero) {
    const Picture picture = landscape(8, 6);
    EXPECT_EQ(correlation(picture.view(), flat(8, 6, {9, 9, 9}).view()), 0.0);
    EXPECT_EQ(correlation(flat(8, 6, {9, 9, 9}).view(), picture.view()), 0.0);
}

TEST(BestFit, FindsAPartAtItsPlaceAndSize) {
    const Picture whole = landscape(160, 120);
    const Picture part = resized(cropped(whole.view(), {30, 40, 80, 60}).view(), 200, 150);
    std::vector<int> widths(141);
    std::iota(widths.begin(), widths.end(), 20);
    const Fit fit = bestFit(whole.view(), part.view(), widths);
    EXPECT_GT(fit.correlation, 0.99);
    EXPECT_NEAR(fit.box.x, 30, 1);
    EXPECT_NEAR(fit.box.y, 40, 1);
    EXPECT_NEAR(fit.box.width, 80, 2);
}

TEST(BestFit, SaysNothingWhereThePartNeverFitsInOrIsFlat) {
    const Picture whole = landscape(40, 30);
    const std::vector<int> tooWide{41, 80};
    EXPECT_EQ(bestFit(whole.view(), whole.view(), tooWide).correlation, 0.0);
    const std::vector<int> widths{10, 20};
    EXPECT_EQ(bestFit(whole.view(), flat(9, 9, {1, 2, 3}).view(), widths).correlation, 0.0);
    EXPECT_EQ(bestFit(flat(40, 30, {1, 2, 3}).view(), whole.view(), widths).correlation, 0.0);
}

}  // namespace
}  // namespace ticker::metrics
