#include <grader/tasks/shadows/questions/ShadowQuestions.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace ticker::tasks {
namespace {

// Code without a clamp may show a light behind the surface as a highlight. The judgement must not
// depend on that.
TEST(LightBehind, IsBelowTheSurfaceAndReflectedAwayFromTheViewer) {
    std::size_t points = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (const ShadowQuestion& asked : drawShadowQuestions(seed)) {
            if (asked.purpose != ShadowQuestion::Purpose::lightBehind) continue;
            const auto& lights = asked.question.scene.pointLights;
            ASSERT_EQ(lights.size(), 3U);
            for (const probe::LitPoint& point : asked.question.points) {
                const auto towards = [&](std::size_t i) {
                    return (lights[i].position() - point.position).normalised();
                };
                const raytracer::Vector3 viewer = (point.viewer - point.position).normalised();
                EXPECT_GT(towards(0).dot(point.normal), 0.05);
                EXPECT_LT(towards(1).dot(point.normal), -0.05);
                EXPECT_GT(towards(2).dot(point.normal), 0.05);
                EXPECT_LT(towards(1).reflectIn(point.normal).dot(viewer), -0.15) << seed;
                ++points;
            }
        }
    EXPECT_GE(points, 40U * 8U);
}

}  // namespace
}  // namespace ticker::tasks
