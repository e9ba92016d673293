#include "PngBuilder.h"

#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace raytracer {
namespace {

using ticker::testing::equalRows;
using ticker::testing::makePng;
using ticker::testing::PngHeader;
using ticker::tests::TemporaryFolder;

std::string greyMap(char byte) {
    const PngHeader header{8, 4, 8, ticker::testing::PngColour::grey};
    return makePng(header, equalRows(header, std::string(8, byte)));
}

SceneDescription read(const std::string& elements) {
    const TemporaryFolder folder;
    return readScene(folder.write("scene.xml", "<scene>" + elements + "</scene>"), {});
}

TEST(ReadScene, GivesTheOriginalsDefaults) {
    const SceneDescription scene = read(
        "<sphere colour='#000000'/><plane colour='#000000' ny='2'/>"
        "<point-light colour='#000000'/>");

    EXPECT_EQ(scene.ambientLighting, ColourRGB(1.0));
    ASSERT_EQ(scene.spheres.size(), 1U);
    EXPECT_EQ(scene.spheres[0].centre, Vector3());
    EXPECT_EQ(scene.spheres[0].radius, 1.0);
    EXPECT_EQ(scene.spheres[0].heightMap, nullptr);
    ASSERT_EQ(scene.planes.size(), 1U);
    EXPECT_EQ(scene.planes[0].normal, Vector3(0.0, 2.0, 0.0));
    for (const Material& material : {scene.spheres[0].material, scene.planes[0].material}) {
        EXPECT_EQ(material.phongKD, 0.8);
        EXPECT_EQ(material.phongKS, 1.2);
        EXPECT_EQ(material.phongAlpha, 10.0);
        EXPECT_EQ(material.reflectivity, 0.3);
    }
    ASSERT_EQ(scene.pointLights.size(), 1U);
    EXPECT_EQ(scene.pointLights[0].intensity(), 100.0);
}

TEST(ReadScene, ReadsEveryAttribute) {
    const SceneDescription scene = read(
        "<ambient-light colour='#204060' intensity='0.5'/>"
        "<point-light x='1' y='2' z='3' colour='#FF0000' intensity='450'/>"
        "<sphere x='4' y='5' z='6' radius='7' colour='#00ff00' kD='0.1' kS='0.2' alphaS='30' "
        "reflectivity='0.4'/>"
        "<plane x='8' y='9' z='10' nx='0' ny='0.9825' nz='-0.186' colour='#0000FF'/>");

    EXPECT_EQ(scene.ambientLighting, ColourRGB(0x20 / 255.0, 0x40 / 255.0, 0x60 / 255.0) * 0.5);
    EXPECT_EQ(scene.pointLights[0].position(), Vector3(1.0, 2.0, 3.0));
    EXPECT_EQ(scene.pointLights[0].colour(), ColourRGB(1.0, 0.0, 0.0));
    EXPECT_EQ(scene.pointLights[0].intensity(), 450.0);
    EXPECT_EQ(scene.spheres[0].centre, Vector3(4.0, 5.0, 6.0));
    EXPECT_EQ(scene.spheres[0].radius, 7.0);
    EXPECT_EQ(scene.spheres[0].material.colour, ColourRGB(0.0, 1.0, 0.0));
    EXPECT_EQ(scene.spheres[0].material.phongKD, 0.1);
    EXPECT_EQ(scene.spheres[0].material.phongKS, 0.2);
    EXPECT_EQ(scene.spheres[0].material.phongAlpha, 30.0);
    EXPECT_EQ(scene.spheres[0].material.reflectivity, 0.4);
    EXPECT_EQ(scene.planes[0].point, Vector3(8.0, 9.0, 10.0));
    EXPECT_EQ(scene.planes[0].normal, Vector3(0.0, 0.9825, -0.186));
    EXPECT_EQ(scene.planes[0].material.colour, ColourRGB(0.0, 0.0, 1.0));
}

TEST(ReadScene, TakesColoursAsLinearWithoutDecoding) {
    const SceneDescription scene = read("<sphere colour='#80407F'/>");

    EXPECT_EQ(scene.spheres[0].material.colour, ColourRGB(128 / 255.0, 64 / 255.0, 127 / 255.0));
}

TEST(ReadScene, AcceptsWhatEditorsAdd) {
    const TemporaryFolder folder;
    const auto file = folder.write("scene.xml",
                                   "\xEF\xBB\xBF<?xml version='1.0' encoding='UTF-8'?>\r\n"
                                   "<!-- mine -->\r\n<scene>\r\n<!-- \xE2\x86\xAA -->\r\n"
                                   "<sphere colour='#123456'\r\n/></scene>\r\n<!-- end -->\r\n");

    EXPECT_EQ(readScene(file, {}).spheres.size(), 1U);
}

TEST(ReadScene, PrefersTheMapBesideTheScene) {
    const TemporaryFolder folder;
    folder.write("assets/map.png", greyMap('\x00'));
    folder.write("scenes/map.png", greyMap('\xFF'));
    const auto file = folder.write("scenes/scene.xml",
                                   "<scene><bumpy-sphere colour='#123456' bump-map='map.png'/>"
                                   "</scene>");

    const SceneDescription scene = readScene(file, folder.path() / "assets");

    ASSERT_NE(scene.spheres.at(0).heightMap, nullptr);
    EXPECT_EQ(scene.spheres[0].heightMap->at(0, 0), kBumpFactor);
}

TEST(ReadScene, FindsMapsInTheAssetsAndSharesThem) {
    const TemporaryFolder folder;
    folder.write("assets/maps/map.png", greyMap('\x00'));
    const auto file = folder.write(
        "scenes/scene.xml",
        "<scene><bumpy-sphere colour='#123456' bump-map='maps/map.png'/>"
        "<bumpy-sphere x='2' colour='#123456' bump-map='maps/map.png' kD='0.5'/></scene>");

    const SceneDescription scene = readScene(file, folder.path() / "assets");

    ASSERT_EQ(scene.spheres.size(), 2U);
    EXPECT_EQ(scene.spheres[0].heightMap, scene.spheres[1].heightMap);
    EXPECT_EQ(scene.spheres[0].heightMap->width(), 8);
    EXPECT_EQ(scene.spheres[1].material.phongKD, 0.5);
}

TEST(ReadScene, FollowsNoLinkOutOfItsFolders) {
    const TemporaryFolder folder;
    folder.write("secret/map.png", greyMap('\x00'));
    const auto file = folder.write("scenes/scene.xml",
                                   "<scene>\n<bumpy-sphere colour='#123456' bump-map='map.png'/>"
                                   "</scene>");
    std::filesystem::create_symlink("../secret/map.png", folder.path() / "scenes/map.png");

    try {
        (void)readScene(file, {});
        FAIL() << "a link out of the folder was followed";
    } catch (const InputError& error) {
        EXPECT_EQ(error.line(), 2);
        EXPECT_NE(std::string(error.what()).find("link out of it"), std::string::npos);
    }
}

TEST(ReadScene, AcceptsAFolderThatIsItselfALink) {
    const TemporaryFolder folder;
    folder.write("real/map.png", greyMap('\x00'));
    const auto file = folder.write("scene.xml",
                                   "<scene><bumpy-sphere colour='#123456' bump-map='map.png'/>"
                                   "</scene>");
    std::filesystem::create_directory_symlink("real", folder.path() / "assets");

    EXPECT_NE(readScene(file, folder.path() / "assets").spheres.at(0).heightMap, nullptr);
}

}  // namespace
}  // namespace raytracer
