// The scene files can be read, are listed in scenes/README.md, have the handout's values, and show
// what their comments promise.

#include <raytracer/io/SceneReader.h>
#include <raytracer/render/Renderer.h>

#include <grader/tests/io/BytesOf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

namespace raytracer {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = TICKER_SOURCE_DIR;

SceneDescription sceneCalled(const std::string& name) {
    return readScene(kSource / "scenes" / name, kSource / "assets");
}

ColourRGB bytes(int r, int g, int b) {
    return {r / 255.0, g / 255.0, b / 255.0};
}

TEST(Scenes, AreAllReadableExplainedAndListed) {
    const std::string list = ticker::testing::bytesOf(kSource / "scenes/README.md");
    int count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(kSource / "scenes")) {
        if (entry.path().extension() != ".xml") continue;
        ++count;
        const std::string name = entry.path().filename();
        EXPECT_NO_THROW((void)sceneCalled(name)) << name;
        EXPECT_TRUE(ticker::testing::bytesOf(entry.path()).starts_with("<!-- ")) << name;
        EXPECT_NE(list.find("`" + name + "`"), std::string::npos) << name;
    }
    EXPECT_GE(count, 8);
}

TEST(BumpMappingScene, HasTheHandoutsValues) {
    for (const std::string name : {"bump-mapping.xml", "bumpmap-test.xml"}) {
        const SceneDescription scene = sceneCalled(name);

        EXPECT_EQ(scene.ambientLighting, bytes(5, 5, 5));
        ASSERT_EQ(scene.pointLights.size(), 2U);
        EXPECT_EQ(scene.pointLights[0].position(), Vector3(1.0, 3.0, 2.0));
        EXPECT_EQ(scene.pointLights[0].colour(), bytes(0xB3, 0xDD, 0xFF));
        EXPECT_EQ(scene.pointLights[0].intensity(), 100.0);
        EXPECT_EQ(scene.pointLights[1].position(), Vector3(-5.0, 1.0, 4.0));
        EXPECT_EQ(scene.pointLights[1].colour(), bytes(0xFF, 0xB0, 0xB2));
        EXPECT_EQ(scene.pointLights[1].intensity(), 100.0);
        ASSERT_EQ(scene.spheres.size(), 1U);
        EXPECT_EQ(scene.spheres[0].centre, Vector3(0.0, 0.0, 3.5));
        EXPECT_EQ(scene.spheres[0].radius, 0.7);
        EXPECT_EQ(scene.spheres[0].material.colour, bytes(0xF4, 0x5B, 0x00));
        EXPECT_NE(scene.spheres[0].heightMap, nullptr);
        EXPECT_TRUE(scene.planes.empty());
    }
}

TEST(DistributedScene, HasTheHandoutsValues) {
    const SceneDescription scene = sceneCalled("distributed.xml");

    EXPECT_EQ(scene.ambientLighting, bytes(5, 5, 5));
    ASSERT_EQ(scene.pointLights.size(), 1U);
    EXPECT_EQ(scene.pointLights[0].position(), Vector3(-1.5, 4.5, 2.0));
    EXPECT_EQ(scene.pointLights[0].colour(), bytes(0xE1, 0xF2, 0xEF));
    EXPECT_EQ(scene.pointLights[0].intensity(), 450.0);
    ASSERT_EQ(scene.spheres.size(), 4U);
    EXPECT_EQ(scene.spheres[0].centre, Vector3(0.5, -0.26398, 3.51805));
    EXPECT_EQ(scene.spheres[1].centre, Vector3(-0.2, 0.01504, 4.99187));
    EXPECT_EQ(scene.spheres[2].centre, Vector3(-0.9, 0.29406, 6.46569));
    EXPECT_EQ(scene.spheres[3].centre, Vector3(-1.6, 0.57308, 7.93951));
    for (const SphereDescription& sphere : scene.spheres) {
        EXPECT_EQ(sphere.radius, 0.5);
        EXPECT_EQ(sphere.material.colour, bytes(0x05, 0x1A, 0x34));
    }
    ASSERT_EQ(scene.planes.size(), 2U);
    EXPECT_EQ(scene.planes[0].point, Vector3(0.0, -0.47623, 5.085));
    EXPECT_EQ(scene.planes[0].normal, Vector3(0.0, 0.9825, -0.186));
    EXPECT_EQ(scene.planes[0].material.colour, bytes(0x82, 0x89, 0x8F));
    EXPECT_EQ(scene.planes[1].point, Vector3(0.0, 0.0, 12.0));
    EXPECT_EQ(scene.planes[1].normal, Vector3(0.0, 0.0, -1.0));
    EXPECT_EQ(scene.planes[1].material.colour, bytes(0x51, 0x6E, 0x7E));
}

bool isHidden(const Scene& scene, const Vector3& from, const Vector3& target) {
    const Vector3 towards = target - from;
    const auto hit = scene.findClosestIntersection({from, towards.normalised()});
    return hit && hit->distance < towards.magnitude();
}

/// Calls `visit(point)` for points all over the visible part of the floor.
template <typename Visit>
void forFloorPoints(Visit visit) {
    for (int i = -20; i <= 20; ++i)
        for (int j = 0; j <= 40; ++j)
            visit(Vector3{i * 0.1, -1.0 + kShadowBias, 3.5 + j * 0.1});
}

TEST(PenumbraScene, ShowsFullLightFullShadowAndWhatIsBetween) {
    const Scene scene{sceneCalled("penumbra.xml")};
    const Vector3 light = scene.pointLights().at(0).position();
    std::set<int> hiddenCounts;
    forFloorPoints([&](const Vector3& point) {
        int hidden = 0;
        for (int i = 0; i < 10; ++i)
            hidden += isHidden(scene, point, light + Vector3{-0.36 + 0.08 * i, 0.0, 0.0}) ? 1 : 0;
        hiddenCounts.insert(hidden);
    });
    EXPECT_EQ(hiddenCounts.size(), 11U) << "every share from 0 to 10 of 10 should occur";
}

TEST(TwoLightsScene, HasPointsHiddenFromNoneEitherAndBoth) {
    const Scene scene{sceneCalled("two-lights.xml")};
    std::set<int> cases;
    forFloorPoints([&](const Vector3& point) {
        const bool first = isHidden(scene, point, scene.pointLights().at(0).position());
        const bool second = isHidden(scene, point, scene.pointLights().at(1).position());
        cases.insert((first ? 1 : 0) + (second ? 2 : 0));
    });
    EXPECT_EQ(cases.size(), 4U);
}

TEST(BeyondTheLightScene, HasAnObjectBehindTheLight) {
    const Scene scene{sceneCalled("beyond-the-light.xml")};
    const Vector3 light = scene.pointLights().at(0).position();
    int beyond = 0;
    int before = 0;
    forFloorPoints([&](const Vector3& point) {
        const Vector3 towards = light - point;
        const auto hit = scene.findClosestIntersection({point, towards.normalised()});
        if (!hit || hit->object->colour() == bytes(0x60, 0x70, 0x80)) return;
        (hit->distance > towards.magnitude() + RenderSettings{}.lightSize ? beyond : before) += 1;
    });
    EXPECT_GT(beyond, 100);
    EXPECT_GT(before, 5);
}

TEST(LensGridScene, HasDiscsOfEqualSizeAndOneInFocus) {
    const SceneDescription scene = sceneCalled("lens-grid.xml");
    ASSERT_EQ(scene.spheres.size(), 24U);
    for (const SphereDescription& sphere : scene.spheres)
        // The file has four decimals.
        EXPECT_NEAR(sphere.radius / sphere.centre.z, 0.04, 1e-4);
    EXPECT_EQ(std::ranges::count(scene.spheres, RenderSettings{}.dofFocalPlane,
                                 [](const SphereDescription& sphere) { return sphere.centre.z; }),
              1);
}

}  // namespace
}  // namespace raytracer
