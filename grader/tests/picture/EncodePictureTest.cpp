#include <grader/picture/EncodePicture.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <random>

namespace ticker::picture {
namespace {

using raytracer::ByteImage;

ByteImage noise(int width, int height) {
    ByteImage image{width, height, {}};
    image.rgb.resize(static_cast<std::size_t>(3 * width * height));
    std::mt19937 generator{3};
    for (std::uint8_t& byte : image.rgb)
        byte = static_cast<std::uint8_t>(generator());
    return image;
}

TEST(EncodePicture, KeepsEveryPixel) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{7, 3}, std::pair{320, 240}}) {
        const ByteImage image = noise(width, height);
        const ByteImage again = raytracer::decodeImage(encodePicture(image), "again");
        EXPECT_EQ(again.width, width);
        EXPECT_EQ(again.height, height);
        EXPECT_EQ(again.rgb, image.rgb);
    }
}

TEST(EncodePicture, GivesEqualFilesForEqualPictures) {
    EXPECT_EQ(encodePicture(noise(64, 48)), encodePicture(noise(64, 48)));
}

TEST(EncodePicture, RefusesWhatIsNoPicture) {
    EXPECT_THROW((void)encodePicture({0, 4, {}}), raytracer::Error);
    EXPECT_THROW((void)encodePicture({2, 2, {1, 2, 3}}), raytracer::Error);
}

}  // namespace
}  // namespace ticker::picture
