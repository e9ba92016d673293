#include <student_template/framework/app/view/Stages.h>

#include <raytracer/io/ImageWriter.h>
#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <vector>

namespace raytracer::view {
namespace {

SceneDescription oneBall() {
    SceneDescription scene;
    scene.pointLights.emplace_back(Vector3{2.0, 3.0, 1.0}, ColourRGB{1.0}, 100.0);
    scene.spheres.push_back({{0.0, 0.0, 4.0}, 1.0, {}, nullptr});
    return scene;
}

RenderSettings small() {
    RenderSettings settings;
    settings.width = 200;
    settings.height = 130;
    settings.dofRayCount = 5;
    settings.shadowRayCount = 2;
    settings.seed = 4;
    return settings;
}

TEST(Stages, BeginCoarselyAndEndWithThePictureAsItIs) {
    const Scene scene{oneBall()};
    const RenderSettings settings = small();
    std::vector<Part> parts;
    renderInStages(
        scene, settings, [&](const Part& part) { parts.push_back(part); }, [] { return false; });
    ASSERT_EQ(parts.size(), 2U + 4U);
    EXPECT_EQ(parts[0].stage, "1 of 5 rays");
    EXPECT_EQ(parts[0].picture.width, 50);
    EXPECT_EQ(parts[1].stage, "4 of 5 rays");
    EXPECT_TRUE(parts.back().isLast);

    const ByteImage whole = toBytes(Renderer{settings}.render(scene));
    for (const Part& part : parts) {
        if (!part.stage.empty()) continue;
        for (int y = 0; y < part.region.height; ++y)
            for (int x = 0; x < 3 * part.region.width; ++x)
                ASSERT_EQ(part.picture.rgb[static_cast<std::size_t>(3 * part.region.width * y + x)],
                          whole.rgb[static_cast<std::size_t>(
                              3 * (whole.width * (part.region.y + y) + part.region.x) + x)])
                    << x << ", " << y;
    }
}

TEST(Stages, StopWhenAnotherPictureIsWanted) {
    const Scene scene{oneBall()};
    int parts = 0;
    renderInStages(
        scene, small(), [&](const Part&) { ++parts; }, [&] { return parts > 0; });
    EXPECT_EQ(parts, 1);
}

}  // namespace
}  // namespace raytracer::view
