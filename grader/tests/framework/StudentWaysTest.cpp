// Students use the framework's names in various ways: each of these must compile without a warning
// and give the right result.
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <gtest/gtest.h>

#include <array>
#include <thread>
#include <vector>

namespace raytracer {
namespace {

SceneDescription oneSphere() {
    SceneDescription scene;
    scene.pointLights.push_back({{0, 5, 0}, {1, 1, 1}, 100});
    scene.pointLights.push_back({{3, 0, 0}, {1, 0, 0}, 10});
    scene.spheres.push_back({{0, 0, 5}, 1.0, {}, nullptr});
    return scene;
}

RenderSettings small(int threads = 1) {
    RenderSettings settings;
    settings.width = 8;
    settings.height = 6;
    settings.threads = threads;
    return settings;
}

TEST(StudentCode, CanCalculateWithVectors) {
    const Vector3 n{0, 1, 0};
    Vector3 v = 2.0 * n;
    EXPECT_EQ(v, Vector3(0, 2, 0));
    v = 2 * n;
    v = n * 3;
    v *= 2;
    v /= 4;
    EXPECT_EQ(v, n / 2 * 3);
    v += n;
    v -= 2 * n;
    EXPECT_EQ(-v, Vector3(0, 0.5, 0) * -1);
    EXPECT_EQ(Vector3(), Vector3{});
    const auto w = Vector3(1, 2, 3);
    EXPECT_TRUE(w != n);
    const auto [x, y, z] = w;
    EXPECT_EQ(x + y + z, 6.0);
    constexpr Vector3 kUp{0, 1, 0};
    static_assert(kUp.dot(kUp) == 1.0);
}

TEST(StudentCode, GetsTheSameQuotientFromBothDivisionOperators) {
    Vector3 v{1, 2, 3};
    v /= 49;
    EXPECT_EQ(v, Vector3(1, 2, 3) / 49);
    ColourRGB c{1, 2, 3};
    c /= 49;
    EXPECT_EQ(c, ColourRGB(1, 2, 3) / 49);
}

TEST(StudentCode, CanCalculateWithColours) {
    const PointLight light{{}, {0.5, 0.25, 1.0}, 1.0};
    ColourRGB sum{};
    EXPECT_EQ(sum, ColourRGB(0, 0, 0));
    EXPECT_EQ(ColourRGB(0), ColourRGB{0.0});
    const ColourRGB colour(1, 2, 3);
    sum += colour * light.colour();
    sum = sum + 0.5 * colour * 2;
    sum *= light.colour();
    sum /= 1;
    EXPECT_EQ(sum, ColourRGB(0.75, 0.625, 6.0));
    EXPECT_EQ(colour - colour, ColourRGB());
}

TEST(StudentCode, CanMakeRaysWithBracesBracketsOrMembers) {
    const Vector3 a{1, 2, 3};
    const Vector3 b{0, 0, 2};
    const Ray braces{a, b};
    const Ray brackets(a, b);
    Ray later;
    later.origin = a;
    later.direction = b;
    EXPECT_EQ(braces.evaluateAt(2), Vector3(1, 2, 7));
    EXPECT_EQ(brackets.evaluateAt(2), later.evaluateAt(2));
    const Ray fromTemporaries{a + b, (b - a).normalised()};
    EXPECT_EQ(fromTemporaries.origin, Vector3(1, 2, 5));
}

TEST(StudentCode, CanReadAHitAndAMiss) {
    const Scene scene{oneSphere()};
    auto hit = scene.findClosestIntersection(Ray{{}, {0, 0, 1}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit.value().distance, 4.0);
    EXPECT_EQ((*hit).object, scene.objects().front().get());
    if (const auto miss = scene.findClosestIntersection({{}, {0, 1, 0}}); miss) FAIL();
    EXPECT_TRUE(scene.findClosestIntersection({{}, {1, 0, 0}}) == std::nullopt);
    // Twice the direction is half the distance.
    EXPECT_EQ(scene.findClosestIntersection({{}, {0, 0, 2}})->distance, 2.0);
}

TEST(StudentCode, CanLoopOverTheLightsWithOrWithoutAnIndex) {
    const Scene scene{oneSphere()};
    double red = 0.0;
    for (const auto& light : scene.pointLights())
        red += light.colour().r;
    for (auto light : scene.pointLights())
        red += light.colour().r;
    for (std::size_t i = 0; i < scene.pointLights().size(); ++i)
        red += scene.pointLights()[i].colour().r;
    EXPECT_EQ(red, 6.0);
}

TEST(StudentCode, GetsTheSamePixelsFromOneThreadOrSeveral) {
    const Camera camera{small()};
    Image plain{small()};
    for (int y = 0; y < plain.height(); ++y) {
        for (int x = 0; x < plain.width(); ++x)
            plain.set(x, y, ColourRGB{camera.castRay(x, y).direction.z});
    }

    Image parallel{small(3)};
    forEachPixel(parallel, [&](int x, int y) {
        parallel.set(x, y, ColourRGB{camera.castRay(x, y).direction.z});
    });
    EXPECT_EQ(parallel.pixels(), plain.pixels());

    Image ownThreads{small()};
    const auto band = [&](int from, int to) {
        for (int y = from; y < to; ++y) {
            for (int x = 0; x < ownThreads.width(); ++x)
                ownThreads.set(x, y, ColourRGB{camera.castRay(x, y).direction.z});
        }
    };
    std::thread upper{band, 0, 3};
    std::thread lower{band, 3, 6};
    upper.join();
    lower.join();
    EXPECT_EQ(ownThreads.pixels(), plain.pixels());
}

TEST(StudentCode, CanShareASceneBetweenThreads) {
    const Scene scene{oneSphere()};
    std::array<int, 4> hits{};
    std::vector<std::thread> threads;
    for (int& count : hits) {
        threads.emplace_back([&scene, &count] {
            for (int i = 0; i < 500; ++i) {
                const Vector3 direction = Vector3{0, 0, 1} + Vector3::randomInsideUnitSphere();
                if (scene.findClosestIntersection({{}, direction})) ++count;
            }
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    for (const int count : hits)
        EXPECT_GT(count, 0);
}

TEST(StudentCode, CanReturnAnImageMadeFromSettings) {
    const auto make = [] {
        Image image(small());
        image.set(1, 1, ColourRGB(1, 0, 0));
        return image;
    };
    Image image = make();
    image = make();
    EXPECT_EQ(image.at(1, 1).r, 1.0);
}

}  // namespace
}  // namespace raytracer
