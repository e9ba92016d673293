#include "PngBuilder.h"

#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageReader.h>

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace raytracer {
namespace {

using ticker::testing::equalRows;
using ticker::testing::makePng;
using ticker::testing::makePngAround;
using ticker::testing::PngColour;
using ticker::testing::PngHeader;
using ticker::tests::TemporaryFolder;

ByteImage decodeRow(const PngHeader& header, const std::string& row) {
    return decodeImage(makePng(header, equalRows(header, row)), "test.png");
}

TEST(DecodeImage, ReadsGreyLinearly) {
    std::string row;
    for (int value = 0; value < 256; ++value)
        row += static_cast<char>(value);
    const ByteImage image = decodeRow({256, 1, 8, PngColour::grey}, row);

    ASSERT_EQ(image.rgb.size(), 3U * 256U);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        ASSERT_EQ(image.rgb[i], i / 3);
}

TEST(DecodeImage, ReadsColoursAsTheyStand) {
    const ByteImage image =
        decodeRow({2, 1, 8, PngColour::rgb}, std::string("\x01\x80\xFF\xFE\x02\x7F", 6));

    EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{0x01, 0x80, 0xFF, 0xFE, 0x02, 0x7F}));
}

TEST(DecodeImage, DropsAlphaWithoutChangingColours) {
    const ByteImage colour =
        decodeRow({1, 1, 8, PngColour::rgbAlpha}, std::string("\x10\x20\x30\x00", 4));
    const ByteImage grey = decodeRow({1, 1, 8, PngColour::greyAlpha}, std::string("\x40\x00", 2));

    EXPECT_EQ(colour.rgb, (std::vector<std::uint8_t>{0x10, 0x20, 0x30}));
    EXPECT_EQ(grey.rgb, (std::vector<std::uint8_t>{0x40, 0x40, 0x40}));
}

TEST(DecodeImage, KeepsTheUpperByteOfSixteenBits) {
    const ByteImage image =
        decodeRow({3, 1, 16, PngColour::grey}, std::string("\x00\xFF\x80\x80\xFF\xFF", 6));

    EXPECT_EQ(image.rgb,
              (std::vector<std::uint8_t>{0x00, 0x00, 0x00, 0x80, 0x80, 0x80, 0xFF, 0xFF, 0xFF}));
}

TEST(DecodeImage, SpreadsOneBitOverTheWholeRange) {
    const ByteImage image = decodeRow({2, 1, 1, PngColour::grey}, "\x40");

    EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255}));
}

TEST(ReadHeightMap, TakesTheMeanOfTheChannels) {
    const TemporaryFolder folder;
    const PngHeader header{4, 4, 8, PngColour::rgb};
    const std::string row("\x00\x00\x00\x1E\x3C\x5A\xFF\xFF\xFF\x80\x80\x80", 12);
    const auto file = folder.write("map.png", makePng(header, equalRows(header, row)));

    const HeightMap map = readHeightMap(file);

    EXPECT_EQ(map.at(0, 3), 0.0);
    EXPECT_DOUBLE_EQ(map.at(1, 0), kBumpFactor * 60.0 / 255.0);
    EXPECT_EQ(map.at(2, 0), kBumpFactor);
    EXPECT_DOUBLE_EQ(map.at(3, 0), kBumpFactor * 128.0 / 255.0);
}

struct BadImage {
    std::string name;
    std::string bytes;
    std::string expected;

    friend std::ostream& operator<<(std::ostream& out, const BadImage& image) {
        return out << image.name;
    }
};

class BadImageFile : public ::testing::TestWithParam<BadImage> {};

TEST_P(BadImageFile, IsRefusedWithTheFileAndWhatWasExpected) {
    const TemporaryFolder folder;
    const auto file = folder.write("map.png", GetParam().bytes);
    try {
        (void)readHeightMap(file);
        FAIL() << "it was accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
        EXPECT_NE(message.find(GetParam().expected), std::string::npos) << message;
        EXPECT_EQ(error.exitCode(), ExitCode::badInput);
    }
}

std::string goodImage() {
    const PngHeader header{4, 4, 8, PngColour::grey};
    return makePng(header, equalRows(header, "abcd"));
}

std::string withoutEnd(std::size_t bytes) {
    const std::string good = goodImage();
    return good.substr(0, good.size() - bytes);
}

const auto kBadImages = ::testing::Values(
    BadImage{"Empty", "", "the file is empty"}, BadImage{"Text", "hello", "no picture"},
    BadImage{"Jpeg", "\xFF\xD8\xFF\xE0 and so on", "JPEG picture; expected a PNG"},
    BadImage{"Gif", "GIF89a", "GIF picture; expected a PNG"},
    BadImage{"Bmp", "BM1234", "BMP picture; expected a PNG"},
    BadImage{"Ppm", "P6\n1 1\n255\nabc", "PPM picture; expected a PNG"},
    BadImage{"WebP", "RIFF1234WEBPVP8 ", "WebP picture; expected a PNG"},
    BadImage{"SignatureAlone", "\x89PNG\r\n\x1A\n", "damaged"},
    BadImage{"WithoutData", withoutEnd(40), "damaged"},
    BadImage{"CutInTheData", withoutEnd(20), "damaged"},
    BadImage{"NoWidth", makePng({0, 4, 8, PngColour::grey}, ""), "damaged"},
    BadImage{"NoHeight", makePng({4, 0, 8, PngColour::grey}, ""), "damaged"},
    BadImage{"UnknownDepth", makePng({4, 4, 3, PngColour::grey}, ""), "damaged"},
    BadImage{"UnknownColour", makePng({4, 4, 8, PngColour{5}}, ""), "damaged"},
    BadImage{"UnknownFilter", makePng({4, 1, 8, PngColour::grey}, "\x09 abcd"), "damaged"},
    BadImage{"TooFewRows", makePng({4, 4, 8, PngColour::grey}, std::string(10, '\0')), "damaged"},
    BadImage{"TooWide", makePng({16385, 4, 8, PngColour::grey}, ""), "damaged"},
    BadImage{"HugeSides", makePng({0x7FFFFFFF, 0x7FFFFFFF, 8, PngColour::grey}, ""), "damaged"},
    BadImage{"TooManyPixels", makePng({16000, 16000, 8, PngColour::grey}, ""), "64 million"},
    BadImage{"ThreeTexelsWide", makePng({3, 4, 8, PngColour::grey}, std::string(16, '\0')),
             "at least 4"},
    BadImage{"ThreeTexelsHigh", makePng({4, 3, 8, PngColour::grey}, std::string(15, '\0')),
             "at least 4"});

INSTANTIATE_TEST_SUITE_P(Images, BadImageFile, kBadImages,
                         [](const ::testing::TestParamInfo<BadImage>& image) {
                             return image.param.name;
                         });

/// Bits in deflate's order (RFC 1951, section 3.1.1).
class BitWriter {
public:
    void write(const std::string& bits) {
        for (const char bit : bits) {
            byte_ |= (bit == '1' ? 1U : 0U) << count_;
            if (++count_ < 8) continue;
            bytes_ += static_cast<char>(byte_);
            byte_ = 0;
            count_ = 0;
        }
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    unsigned byte_ = 0;
    unsigned count_ = 0;
};

TEST(DecodeImage, RefusesASmallFileThatUnpacksToGigabytes) {
    // With the fixed code "repeat the last byte 258 times" takes 13 bits (RFC 1951, section 3.2.6).
    // 2.5 million of them are 4 MB that unpack to 645 MB, far more than 4 x 4 pixels need and more
    // than the reader allows a decoder to allocate.
    const std::string begin = "110";  // the only block, of the fixed code
    const std::string zeroByte = "00110000";
    const std::string repeat = "1100010100000";
    const std::string end = "0000000";
    BitWriter packed;
    packed.write(begin + zeroByte);
    for (int i = 0; i < 2'500'000; ++i)
        packed.write(repeat);
    packed.write(end + std::string(40, '0'));  // and a check sum, which is never read
    const std::string file = makePngAround({4, 4, 8, PngColour::grey}, "\x78\x01" + packed.bytes());

    EXPECT_THROW((void)decodeImage(file, "bomb.png"), InputError);
}

TEST(ReadImage, RefusesWhatIsNoReadableFile) {
    const TemporaryFolder folder;
    EXPECT_THROW((void)readImage(folder.path() / "no-such.png"), InputError);
    EXPECT_THROW((void)readImage(folder.path()), InputError);
    EXPECT_THROW((void)readImage("/dev/zero"), InputError);
}

}  // namespace
}  // namespace raytracer
