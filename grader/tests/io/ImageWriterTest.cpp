#include "BytesOf.h"

#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>
#include <raytracer/image/ToneCurve.h>
#include <raytracer/io/ImageWriter.h>

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <iterator>
#include <string>

namespace raytracer {
namespace {

namespace fs = std::filesystem;
using ticker::testing::bytesOf;
using ticker::tests::TemporaryFolder;

Image gradient() {
    Image image(3, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            image.set(x, y, {0.1 * x, 0.3 * y, 2.0});
    return image;
}

TEST(WritePng, GivesBackWhatItWrote) {
    const TemporaryFolder folder;
    ByteImage written{5, 3, {}};
    for (int i = 0; i < 45; ++i)
        written.rgb.push_back(static_cast<std::uint8_t>(i * 17 % 256));

    writePng(written, folder.path() / "a.png");
    const ByteImage read = readImage(folder.path() / "a.png");

    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.rgb, written.rgb);
}

TEST(WritePng, PutsLinearColoursThroughTheToneCurve) {
    const TemporaryFolder folder;
    writePng(gradient(), folder.path() / "a.png");
    const ByteImage read = readImage(folder.path() / "a.png");

    ASSERT_EQ(read.rgb.size(), 18U);
    EXPECT_EQ(read.rgb[3], toneMapped(0.1));
    EXPECT_EQ(read.rgb[10], toneMapped(0.3));
    EXPECT_EQ(read.rgb[11], toneMapped(2.0));
}

TEST(WritePng, ReplacesAFileAndLeavesNothingElseBehind) {
    const TemporaryFolder folder;
    folder.write("a.png", "old");
    writePng(gradient(), folder.path() / "a.png");

    EXPECT_EQ(readImage(folder.path() / "a.png").width, 3);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WritePng, WritesThroughALink) {
    const TemporaryFolder folder;
    folder.write("real.png", "old");
    fs::create_symlink("real.png", folder.path() / "link.png");
    writePng(gradient(), folder.path() / "link.png");

    EXPECT_TRUE(fs::is_symlink(folder.path() / "link.png"));
    EXPECT_EQ(readImage(folder.path() / "real.png").width, 3);
}

void expectNotWritable(const fs::path& file, const std::string& expected) {
    try {
        writePng(gradient(), file);
        FAIL() << "it was written";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
}

TEST(WritePng, SaysWhyItCannotWrite) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "folder.png");
    expectNotWritable(folder.path() / "missing/a.png", "does not exist");
    expectNotWritable(folder.path() / "folder.png", "this is a folder");
    expectNotWritable("/dev/null", "no regular file");
    expectNotWritable("", "names no file");
    expectNotWritable(folder.path() / (std::string(300, 'a') + ".png"), "no file can be made");
}

TEST(WritePfm, WritesLinearFloatsFromTheBottomRow) {
    const TemporaryFolder folder;
    writePfm(gradient(), folder.path() / "a.pfm");
    const std::string bytes = bytesOf(folder.path() / "a.pfm");

    const std::string header = "PF\n3 2\n-1.0\n";
    ASSERT_EQ(bytes.substr(0, header.size()), header);
    ASSERT_EQ(bytes.size(), header.size() + 18 * sizeof(float));
    float bottomLeft[3];
    std::memcpy(bottomLeft, bytes.data() + header.size(), sizeof(bottomLeft));
    EXPECT_EQ(bottomLeft[0], 0.0F);
    EXPECT_EQ(bottomLeft[1], 0.3F);
    EXPECT_EQ(bottomLeft[2], 2.0F);
}

}  // namespace
}  // namespace raytracer
