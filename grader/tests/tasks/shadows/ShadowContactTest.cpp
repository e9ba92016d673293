#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

namespace ticker::tasks {
namespace {

/// Points of this zone, in full shadow by default, with these shares of the light.
std::optional<Finding> judgeContact(const std::vector<double>& shares, Zone zone = Zone::umbra) {
    ShadowByHand made;
    made.ask(ShadowQuestion::Purpose::contact);
    for (const double share : shares) {
        PointLog& point = made.point();
        point.zones = {zone};
        point.colour = ambientPart(point, made.last().scene()) +
                       unshadowed(point, made.last().scene(), 0, false) * share;
    }
    return checkContact(made.logs());
}

TEST(CheckContact, AcceptsAmbientLightAlone) {
    EXPECT_FALSE(judgeContact({0.0, 0.0, 1e-5}));
    EXPECT_FALSE(judgeContact({}));
    EXPECT_FALSE(judgeContact({1.0}, Zone::penumbra)) << "only full shadow is certain";
}

TEST(CheckContact, FindsASingleRayThatArrivesAtOnePoint) {
    EXPECT_EQ(idOf(judgeContact({0.0, 0.1})), "shadow.wrong");
    EXPECT_EQ(idOf(judgeContact({1.0, 1.0})), "shadow.wrong");
}

TEST(ContactQuestion, HasABallOnTheFloorCloseAboveEachPoint) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Draw draw{seed, 21};
        const ShadowQuestion drawn = drawContact(draw);
        const raytracer::SceneDescription& scene = drawn.question.scene;
        EXPECT_EQ(drawn.zones, std::vector<std::vector<Zone>>(12, {Zone::umbra}));
        const raytracer::PlaneDescription& floor = scene.planes.at(0);
        const raytracer::SphereDescription& ball = scene.spheres.at(0);
        EXPECT_NEAR((ball.centre - floor.point).dot(floor.normal), ball.radius, 1e-9);
        const Surfaces surfaces{scene};
        for (const probe::LitPoint& point : drawn.question.points) {
            const Vector3 start = point.position + point.normal * 1e-3;
            const Vector3 way = (scene.pointLights.at(0).position() - start).normalised();
            EXPECT_EQ(surfaces.sightAlong(start, way, 0.0095), Sight::blocked);
            EXPECT_EQ(surfaces.sightAlong(start, way, 0.004), Sight::open);
        }
    }
}

}  // namespace
}  // namespace ticker::tasks
