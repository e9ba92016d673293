#include <grader/tasks/lens/answers/LensMeans.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

namespace ticker::tasks {
namespace {

using probe::ColourRGB;
using Pixels = std::vector<PixelMean>;

/// Pixels of many colours, some above 1, that are right.
Pixels rightPixels(int count = 24) {
    Pixels pixels;
    for (int i = 0; i < count; ++i) {
        const ColourRGB mean{0.1 + 0.07 * i, 0.9 - 0.03 * i, 0.2 + std::abs(std::sin(i))};
        pixels.push_back({mean, mean, 50.0});
    }
    return pixels;
}

std::string seenIn(const Pixels& pixels) {
    const auto finding = changeOfMeans(pixels);
    return finding ? finding->id + ": " + finding->message : std::string{};
}

bool says(const std::string& seen, const std::string& id, const std::string& words) {
    return seen.rfind(id, 0) == 0 && seen.find(words) != std::string::npos;
}

Pixels through(const std::function<double(double)>& curve) {
    Pixels pixels = rightPixels();
    for (PixelMean& pixel : pixels)
        pixel.colour = {curve(pixel.mean.r), curve(pixel.mean.g), curve(pixel.mean.b)};
    return pixels;
}

TEST(ChangeOfMeans, IsNamedASumThatIsNeverStartedAnew) {
    for (const double divisor : {1.0, 50.0}) {
        Pixels pixels = rightPixels();
        for (std::size_t i = 1; i < pixels.size(); ++i)
            pixels[i].colour = pixels[i].mean + pixels[i - 1].colour / divisor;
        EXPECT_TRUE(says(seenIn(pixels), "dof.not-averaged", "other pixels")) << divisor;
        pixels[12].colour.g += 0.01;
        EXPECT_EQ(seenIn(pixels), "") << "one pixel is not explained";
    }
}

TEST(ChangeOfMeans, IsNamedAnotherFactorForEachPixel) {
    Pixels pixels = rightPixels();
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i].colour = pixels[i].mean * (0.5 + 0.02 * static_cast<double>((7 * i) % 24));
    EXPECT_TRUE(says(seenIn(pixels), "dof.wrong", "0.5 to 0.96 times"));
    pixels[3].colour.r *= 1.01;
    EXPECT_EQ(seenIn(pixels), "");
}

TEST(ChangeOfMeans, IsNamedACutEvenWhereFewValuesStayBelow) {
    EXPECT_TRUE(says(seenIn(through([](double v) { return std::min(v, 1.0); })), "dof.wrong",
                     "cut off at 1."));
    Pixels pixels = through([](double v) { return std::min(v, 0.02); });
    EXPECT_TRUE(says(seenIn(pixels), "dof.wrong", "cut off at 0.02."));
    pixels[5].colour.b = 0.01;
    EXPECT_EQ(seenIn(pixels), "");
}

TEST(ChangeOfMeans, IsNamedACurveWhereOneExplainsAllPixels) {
    for (const std::function<double(double)>& curve :
         {std::function<double(double)>{[](double v) { return std::sqrt(v); }},
          std::function<double(double)>{[](double v) { return std::floor(255.0 * v) / 255.0; }}}) {
        Pixels pixels = through(curve);
        EXPECT_TRUE(says(seenIn(pixels), "dof.wrong", "curve")) << seenIn(pixels);
        pixels[5].colour.b = 0.0;
        EXPECT_EQ(seenIn(pixels), "");
    }
}

// Means that single precision cannot tell apart may have their values in any order.
TEST(ChangeOfMeans, IsNamedACurveThoughEqualMeansDifferByRounding) {
    Pixels pixels = through([](double v) { return std::sqrt(v); });
    const auto add = [&](double step) {
        Pixels more = pixels;
        for (const double side : {0.0, step}) {
            const ColourRGB mean{3.0 + side, 3.1, 3.2};
            more.push_back({mean, ColourRGB{1.75 - 10.0 * side, 1.76, 1.79}, 50.0});
        }
        return seenIn(more);
    };
    EXPECT_TRUE(says(add(0.9e-5), "dof.wrong", "curve"));
    EXPECT_EQ(add(1.1e-5), "");
}

TEST(ChangeOfMeans, IsNotNamedWhereLittleIsKnown) {
    Pixels few = through([](double v) { return v * v; });
    few.resize(5);
    EXPECT_EQ(seenIn(few), "");
    EXPECT_EQ(seenIn(through([](double) { return 0.0; })), "") << "black";
    EXPECT_EQ(seenIn(through([](double v) { return 1.0 - v; })), "") << "a negative";
}

}  // namespace
}  // namespace ticker::tasks
