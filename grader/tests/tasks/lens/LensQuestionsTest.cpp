#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/lens/questions/MixedRenders.h>

#include <raytracer/scene/Scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

constexpr int kRays = 64;

// How many of kRays random rays through the lens hit something.
int hitsOf(const raytracer::Scene& scene, const Vector3& focus, double halfWidth,
           std::mt19937& engine) {
    std::uniform_real_distribution<double> side{-halfWidth, halfWidth};
    int hits = 0;
    for (int i = 0; i < kRays; ++i) {
        const double x = side(engine);
        const Vector3 lens{x, side(engine), 0.0};
        if (scene.findClosestIntersection({lens, focus - lens})) ++hits;
    }
    return hits;
}

void expectBoth(const probe::RenderQuestion& question, double halfWidth, std::mt19937& engine) {
    const raytracer::Scene scene{question.scene};
    int mixed = 0;
    int whole = 0;
    for (int y = 0; y < question.settings.height; ++y)
        for (int x = 0; x < question.settings.width; ++x) {
            const Vector3 pinhole = pinholeDirection(question.settings, x, y);
            const Vector3 focus = pinhole * (question.settings.dofFocalPlane / pinhole.z);
            const int hits = hitsOf(scene, focus, halfWidth, engine);
            if (hits > 0 && hits < kRays) ++mixed;
            if (hits == kRays) ++whole;
        }
    EXPECT_GE(mixed, 3);
    EXPECT_GE(whole, 1);
}

// Only a pixel with hits and misses shows that a mean leaves the misses out. A pixel for which a
// fifth of the lens sees nothing looks whole to 64 rays with a chance of 1e-6.
TEST(LensQuestions, HaveHitsAndMissesInOnePixelAndWholePixelsToo) {
    std::mt19937 engine{22};
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        const LensQuestions asked = drawLensQuestions(seed);
        for (const probe::RenderQuestion* question : {&asked.handout, &asked.other, &asked.odd})
            for (const double share : {1.0, 0.5})
                expectBoth(*question, share * question->settings.dofAmount, engine);
    }
}

// The distance in z between the surface that a direction shows and the focal plane; 0 if it shows
// nothing.
double depthBesideFocus(const probe::RenderQuestion& question, const Vector3& direction) {
    const auto hit =
        raytracer::Scene{question.scene}.findClosestIntersection({Vector3{}, direction});
    return hit ? std::abs(hit->location.z - question.settings.dofFocalPlane) : 0.0;
}

// Code that focuses on the surface in the centre of the picture is right if that surface lies in
// the focal plane anyway.
TEST(LensQuestions, ShowSomethingBesideTheFocalPlaneInTheCentre) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        const LensQuestions asked = drawLensQuestions(seed);
        for (const probe::RenderQuestion* question : {&asked.handout, &asked.other, &asked.odd}) {
            const raytracer::RenderSettings& settings = question->settings;
            EXPECT_GE(depthBesideFocus(*question, {0.0, 0.0, 1.0}), 0.5);
            EXPECT_GE(depthBesideFocus(*question, pinholeDirection(settings, settings.width / 2,
                                                                   settings.height / 2)),
                      0.5);
        }
    }
}

// Code that skips the lens for pixels that are nearly sharp is right if no pixel is.
TEST(LensQuestions, ShowSomethingNearTheFocalPlane) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const LensQuestions asked = drawLensQuestions(seed);
        for (const probe::RenderQuestion* question : {&asked.handout, &asked.other, &asked.odd}) {
            const raytracer::Scene scene{question->scene};
            const raytracer::RenderSettings& settings = question->settings;
            int sharp = 0;
            for (int i = 0; i < settings.width * settings.height; ++i) {
                const Vector3 pinhole =
                    pinholeDirection(settings, i % settings.width, i / settings.width);
                const auto hit = scene.findClosestIntersection({Vector3{}, pinhole});
                if (hit && std::abs(hit->location.z - settings.dofFocalPlane) < 0.3) ++sharp;
            }
            EXPECT_GE(sharp, 1) << seed;
        }
    }
}

std::size_t countOf(const std::vector<probe::RenderQuestion>& renders,
                    bool (*fits)(const probe::RenderQuestion&)) {
    return static_cast<std::size_t>(std::ranges::count_if(renders, fits));
}

TEST(MixedRenders, HaveEachKindOfSceneAndSizeUnderEverySeed) {
    using Asked = probe::RenderQuestion;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const std::vector<Asked> renders = drawMixedRenders(seed);
        ASSERT_EQ(renders.size(), 10U);
        for (const auto fits :
             {+[](const Asked& a) { return a.scene.planes.empty(); },
              +[](const Asked& a) { return a.scene.ambientLighting.r == 0.0; },
              +[](const Asked& a) { return a.scene.ambientLighting.r > 100.0; },
              +[](const Asked& a) {
                  return std::ranges::any_of(a.scene.spheres, [](const auto& ball) {
                      return ball.material.reflectivity > 0.0;
                  });
              },
              +[](const Asked& a) {
                  return std::ranges::any_of(a.scene.spheres,
                                             [](const auto& ball) { return ball.centre.z < 1.0; });
              },
              +[](const Asked& a) { return a.settings.width * a.settings.height == 1; },
              +[](const Asked& a) { return a.settings.width == 1 && a.settings.height > 1; },
              +[](const Asked& a) { return a.settings.height == 1 && a.settings.width > 1; }})
            EXPECT_EQ(countOf(renders, fits), 1U) << seed;
        for (const auto fits : {+[](const Asked& a) { return a.settings.bounces == 0; },
                                +[](const Asked& a) { return a.settings.bounces == 6; },
                                +[](const Asked& a) { return a.settings.dofFocalPlane < 1.0; },
                                +[](const Asked& a) { return a.settings.dofFocalPlane > 20.0; },
                                +[](const Asked& a) { return a.settings.dofAmount > 0.5; }})
            EXPECT_GE(countOf(renders, fits), 1U) << seed;
    }
}

// Code that skips the lens for pixels that are sharp is right if no surface is near enough to the
// focal plane.
TEST(MixedRenders, FocusOnASurfaceInTheLast) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const probe::RenderQuestion asked = drawMixedRenders(seed).back();
        const raytracer::Scene scene{asked.scene};
        double least = 1.0;
        for (int i = 0; i < asked.settings.width * asked.settings.height; ++i) {
            const auto hit = scene.findClosestIntersection(
                {Vector3{}, pinholeDirection(asked.settings, i % asked.settings.width,
                                             i / asked.settings.width)});
            if (hit)
                least = std::min(least, std::abs(hit->location.z - asked.settings.dofFocalPlane));
        }
        EXPECT_LT(least, 1e-9) << seed;
        EXPECT_NE(wordsOf(asked).find("of a surface in the focal plane"), std::string::npos);
    }
}

TEST(MixedRenders, LeaveTheLensOutsideOfEveryObject) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (const probe::RenderQuestion& render : drawMixedRenders(seed))
            for (const auto& ball : render.scene.spheres)
                EXPECT_GT(ball.centre.z - ball.radius, 0.05) << seed;
}

TEST(LensQuestions, AskForAnOddNumberOfRaysBelowTheHandouts) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const int rays = drawLensQuestions(seed).odd.settings.dofRayCount;
        EXPECT_LT(rays, raytracer::RenderSettings{}.dofRayCount);
        for (const int group : {2, 3, 5, 7, 10, 25})
            EXPECT_NE(rays % group, 0) << rays;
        int times = 0;
        for (double done = 0.0; done < 1.0; done += 1.0 / rays)
            ++times;
        EXPECT_EQ(times, rays + 1) << "a loop over fractions";
    }
}

}  // namespace
}  // namespace ticker::tasks
