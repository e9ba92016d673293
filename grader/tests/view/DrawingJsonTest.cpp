#include <student_template/framework/app/view/DrawingJson.h>

#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raytracer::view {
namespace {

using Json = nlohmann::json;

/// A ball between a light and a floor, and a light that reaches the floor.
SceneDescription twoLights() {
    SceneDescription scene;
    scene.pointLights.emplace_back(Vector3{0.0, 3.0, 4.0}, ColourRGB{1.0}, 100.0);
    scene.pointLights.emplace_back(Vector3{3.0, 1.0, 4.0}, ColourRGB{1.0}, 100.0);
    Material dull;
    dull.reflectivity = 0.0;
    scene.spheres.push_back({{0.0, 1.5, 4.0}, 0.8, dull, nullptr});
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, dull});
    return scene;
}

RenderSettings pixelOfTheFloor(RenderObserver* observer) {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 48;
    settings.region = {32, 43, 1, 1};
    settings.dofRayCount = 3;
    settings.dofAmount = 0.01;
    settings.shadowRayCount = 4;
    settings.lightSize = 0.05;
    settings.observer = observer;
    return settings;
}

long countOf(const Json& drawing, const char* kind) {
    return std::ranges::count_if(drawing["rays"],
                                 [&](const Json& ray) { return ray["k"] == kind; });
}

TEST(DrawingJson, HoldsEveryRayOfAPixelUnderTheRayThatLedToIt) {
    PixelLog log;
    const Scene scene{twoLights(), &log};
    const RenderSettings settings = pixelOfTheFloor(&log);
    static_cast<void>(Renderer{settings}.render(scene));
    const Json drawing = Json::parse(drawingOfPixel(log, scene, settings, {32, 43}));
    EXPECT_EQ(countOf(drawing, "camera"), 3);
    EXPECT_EQ(countOf(drawing, "blocked"), 12);
    EXPECT_EQ(countOf(drawing, "arrives"), 12);
    EXPECT_EQ(countOf(drawing, "other"), 0);
    for (const Json& ray : drawing["rays"]) {
        const int before = ray["p"];
        if (ray["k"] == "camera")
            EXPECT_EQ(before, -1);
        else
            EXPECT_EQ(drawing["rays"][static_cast<std::size_t>(before)]["k"], "camera");
        if (ray["k"] == "blocked") {
            EXPECT_EQ(ray["t"], "shadow ray to light 1 is blocked by sphere 1");
            EXPECT_EQ(ray["l"], 0);
        }
    }
    EXPECT_EQ(drawing["spheres"].size(), 1U);
    EXPECT_EQ(drawing["planes"].size(), 1U);
    EXPECT_EQ(drawing["lights"].size(), 2U);
    EXPECT_EQ(drawing["words"][2],
              "Light 1 from the first point: 4 shadow rays, 0 arrive, 4 blocked by sphere 1.");
}

TEST(DrawingJson, TellsOfAPoint) {
    PixelLog log;
    const Scene scene{twoLights(), &log};
    const SceneObject& floor = *scene.objects().back();
    const RaycastHit point{&floor, 1.0, {0.0, -1.0, 4.0}, {0.0, 1.0, 0.0}};
    RenderSettings settings = pixelOfTheFloor(nullptr);
    const ColourRGB colour =
        Renderer{settings}.illuminate(scene, floor, point.location, point.normal, Vector3{});
    const Json drawing = Json::parse(drawingOfPoint(log, scene, settings, point, colour));
    EXPECT_EQ(countOf(drawing, "blocked"), 4);
    EXPECT_EQ(countOf(drawing, "arrives"), 4);
    EXPECT_EQ(drawing["normals"].size(), 1U);
    EXPECT_EQ(drawing["about"], "The point (0, -1, 4) of plane 1");
}

TEST(DrawingJson, ShowsTheSmoothAndTheTiltedNormalOfABumpySphere) {
    SceneDescription description;
    description.spheres.push_back(
        {{0.0, 0.0, 4.0},
         1.0,
         {},
         std::make_shared<HeightMap>(4, 4, std::vector<double>(16, 1.0))});
    PixelLog log;
    const Scene scene{description, &log};
    RenderSettings settings = pixelOfTheFloor(&log);
    settings.region = {32, 24, 1, 1};
    static_cast<void>(Renderer{settings}.render(scene));
    const Json drawing = Json::parse(drawingOfPixel(log, scene, settings, {32, 24}));
    ASSERT_FALSE(drawing["normals"].empty());
    EXPECT_TRUE(drawing["normals"][0].contains("smooth"));
    EXPECT_TRUE(drawing["normals"][0].contains("given"));
}

TEST(DrawingJson, DrawsARayThatMeetsNothingAsFarAsItIsSeen) {
    PixelLog log;
    const Scene scene{twoLights(), &log};
    RenderSettings settings = pixelOfTheFloor(&log);
    settings.region = {0, 0, 1, 1};
    settings.dofRayCount = 1;
    static_cast<void>(Renderer{settings}.render(scene));
    const Json drawing = Json::parse(drawingOfPixel(log, scene, settings, {0, 0}));
    ASSERT_EQ(drawing["rays"].size(), 1U);
    const Json& ray = drawing["rays"][0];
    EXPECT_EQ(ray["t"], "camera ray 1 meets nothing");
    EXPECT_TRUE(ray.value("m", false));
    const auto at = [&](const char* end) {
        return Vector3{ray[end][0].get<double>(), ray[end][1].get<double>(),
                       ray[end][2].get<double>()};
    };
    EXPECT_NEAR((at("b") - at("a")).magnitude(), 4.0, 1e-4);  // numbers have six digits
    EXPECT_TRUE(drawing["normals"].empty());
}

TEST(DrawingJson, TellsOfRaysThatNoTraceHasCast) {
    PixelLog log;
    const Scene scene{twoLights(), &log};
    const Ray down{{3.0, 1.0, 4.0}, {0.0, -2.0, 0.0}};
    const Ray up{{3.0, 1.0, 4.0}, {0.0, 2.0, 0.0}};
    static_cast<void>(scene.findClosestIntersection(down));
    static_cast<void>(scene.findClosestIntersection(up));
    const RenderSettings settings = pixelOfTheFloor(&log);
    const Json alone = Json::parse(drawingOfPixel(log, scene, settings, {1, 2}));
    EXPECT_EQ(alone["words"][0], "Pixel (1, 2) was never set.");
    EXPECT_EQ(alone["words"][1],
              "No camera ray of trace was seen; rays are numbered as they were cast.");
    EXPECT_EQ(alone["rays"][0]["t"], "ray 1 meets plane 1");
    EXPECT_EQ(alone["rays"][1]["t"], "ray 2 meets nothing");
    EXPECT_EQ(alone["rays"][1]["b"], Json({3.0, 5.0, 4.0}));

    static_cast<void>(Renderer{settings}.render(scene));
    const Json beside = Json::parse(drawingOfPixel(log, scene, settings, {32, 43}));
    EXPECT_EQ(countOf(beside, "other"), 2);
    EXPECT_EQ(beside["words"].back(), "2 rays cast outside of trace and illuminate.");
}

}  // namespace
}  // namespace raytracer::view
