#include <grader/metrics/Structure.h>

#include "MadePictures.h"

#include <gtest/gtest.h>

namespace ticker::metrics {
namespace {

// The expected numbers come from cv::quality::QualitySSIM and QualityGMSD of OpenCV 4.6, given the
// same pictures. Floats of another order of sums differ by less than 1e-5.
constexpr double kRounding = 1e-5;

Picture ramp() {
    return makePicture(96, 64, [](int x, int y) { return Rgb{2 * x, 3 * y, 120}; });
}

Picture relief() {
    return makePicture(96, 64, [](int x, int y) {
        const int v = 120 + ((x / 3 + y / 3) % 2) * 16 - 8;
        return Rgb{v, v / 2, 255 - v};
    });
}

/// Colours without order, at an odd size.
Picture disorder(int shift) {
    return makePicture(97, 63, [shift](int x, int y) {
        return Rgb{(x * y + 20 * shift) % 256, (x * 7 + y * (3 + shift)) % 256,
                   (x * x + y * shift) % 200};
    });
}

void expectNear(const Measured& measured, double value, int width, int height, double corner,
                double middle) {
    EXPECT_NEAR(measured.value, value, kRounding);
    ASSERT_EQ(measured.map.width, width);
    ASSERT_EQ(measured.map.height, height);
    const std::vector<float>& map = measured.map.values;
    ASSERT_EQ(map.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    EXPECT_NEAR(map.front(), corner, kRounding);
    EXPECT_NEAR(map[map.size() / 2 + static_cast<std::size_t>(width) / 2], middle, kRounding);
}

TEST(Structure, HasTheSimilarityOfOpenCvsQualityModule) {
    expectNear(ssim(ramp().view(), relief().view()), 0.433103703, 96, 64, 0.2512539, 0.4875729);
    expectNear(ssim(disorder(0).view(), disorder(1).view()), 0.559392366, 97, 63, 0.6859565,
               0.5570312);
}

TEST(Structure, HasTheGradientDeviationOfOpenCvsQualityModule) {
    expectNear(gmsd(ramp().view(), relief().view()), 0.064170582, 48, 32, 0.4392387, 0.7559658);
    expectNear(gmsd(disorder(0).view(), disorder(1).view()), 0.222788257, 48, 32, 0.8212726,
               0.7696888);
}

}  // namespace
}  // namespace ticker::metrics
