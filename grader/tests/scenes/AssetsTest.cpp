#include <tools/make_assets/LetterAsset.h>
#include <tools/make_assets/SkinMap.h>

#include <raytracer/io/ImageReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace assets {
namespace {

using raytracer::ByteImage;

const std::filesystem::path kAssets = std::string(TICKER_SOURCE_DIR) + "/assets";

int heightAt(const ByteImage& map, int column, int row) {
    return map.rgb.at(static_cast<std::size_t>(3) *
                      (static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
                       static_cast<std::size_t>(column)));
}

const ByteImage& letterMap() {
    static const ByteImage map = makeLetterMap();
    return map;
}

const ByteImage& skinMap() {
    static const ByteImage map = makeSkinMap();
    return map;
}

void expectSame(const ByteImage& committed, const ByteImage& made) {
    EXPECT_EQ(committed.width, made.width);
    EXPECT_EQ(committed.height, made.height);
    EXPECT_TRUE(committed.rgb == made.rgb) << "run make_assets, or undo the change that it shows";
}

TEST(LetterMap, IsTheCommittedOne) {
    expectSame(raytracer::readImage(kAssets / "bumpmap-test.png"), letterMap());
}

TEST(SkinMap, IsTheCommittedOne) {
    expectSame(raytracer::readImage(kAssets / "bumpmap.png"), skinMap());
}

TEST(LetterMap, RaisesHAndLowersL) {
    const ByteImage& map = letterMap();
    const auto [lowest, highest] = std::ranges::minmax(map.rgb);
    EXPECT_EQ(lowest, 128 - 120);
    EXPECT_EQ(highest, 128 + 120);

    // The middle of a cell: the bar of an H, and the ground to the right of the stem of an L.
    for (int row = 1; row < 5; ++row)
        for (int column = 0; column < 12; ++column) {
            const int x = (2 * column + 1) * 2048 / 24;
            const int y = (2 * row + 1) * 1024 / 12;
            const bool isH = (row + column) % 2 == 0;
            EXPECT_EQ(heightAt(map, x, y), isH ? 248 : 128);
            EXPECT_EQ(heightAt(map, x - 30, y), isH ? 248 : 8) << "the stem on the left";
            EXPECT_EQ(heightAt(map, x + 30, y), isH ? 248 : 128) << "the stem on the right";
            EXPECT_EQ(heightAt(map, x + 20, y + 46), isH ? 128 + 20 : 8) << "the foot";
        }
}

TEST(LetterMap, HasBevelsAndNoCliffs) {
    const ByteImage& map = letterMap();
    for (int row = 0; row + 1 < map.height; ++row)
        for (int column = 0; column < map.width; ++column) {
            const int here = heightAt(map, column, row);
            ASSERT_LE(std::abs(heightAt(map, (column + 1) % map.width, row) - here), 20);
            ASSERT_LE(std::abs(heightAt(map, column, row + 1) - here), 20);
        }
}

TEST(SkinMap, HasNoSeamAndNoCliffs) {
    const ByteImage& map = skinMap();
    int steepestInside = 0;
    int steepestAtSeam = 0;
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column) {
            const int next = (column + 1) % map.width;
            int& steepest = next == 0 ? steepestAtSeam : steepestInside;
            steepest =
                std::max(steepest, std::abs(heightAt(map, next, row) - heightAt(map, column, row)));
        }
    EXPECT_LE(steepestAtSeam, steepestInside);
    // 100 of 255 bytes at a bump factor of 5: a tilt of 63 degrees.
    EXPECT_LT(steepestInside, 100);
}

TEST(BothMaps, AreCalmAtThePolesAndGrey) {
    for (const ByteImage& map : {letterMap(), skinMap()}) {
        for (int column = 0; column < map.width; ++column)
            for (const int row : {0, 1, map.height - 2, map.height - 1})
                ASSERT_NEAR(heightAt(map, column, row), 128, 1);
        for (std::size_t i = 0; i < map.rgb.size(); i += 3)
            ASSERT_TRUE(map.rgb[i] == map.rgb[i + 1] && map.rgb[i] == map.rgb[i + 2]);
    }
}

TEST(BothMaps, AreSmallFiles) {
    for (const std::string name : {"bumpmap.png", "bumpmap-test.png"})
        EXPECT_LT(std::filesystem::file_size(kAssets / name), 1'000'000U) << name;
}

}  // namespace
}  // namespace assets
