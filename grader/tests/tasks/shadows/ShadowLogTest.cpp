#include <grader/tests/tasks/shadows/ReplayCase.h>

#include <gtest/gtest.h>

#include <limits>

namespace ticker::tasks {
namespace {

using probe::Event;

/// Two points under two lights, and events about them.
struct Logged {
    ShadowQuestion question;
    probe::IlluminateAnswer answer;

    Logged() {
        raytracer::SceneDescription& scene = question.question.scene;
        scene.pointLights.emplace_back(Vector3{0.0, 4.0, 0.0}, ColourRGB{1.0}, 1.0);
        scene.pointLights.emplace_back(Vector3{4.0, 4.0, 0.0}, ColourRGB{1.0}, 1.0);
        scene.planes.push_back({{}, {0.0, 1.0, 0.0}, {}});
        for (const double x : {0.0, 1.0})
            question.question.points.push_back(
                {0, {x, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 3.0, 0.0}});
        question.zones = {{Zone::lit, Zone::lit}, {Zone::lit, Zone::umbra}};
        answer.colours = {{0.1, 0.2, 0.3}};
    }
    void cast(std::uint32_t ask, const Vector3& origin, const Vector3& direction,
              Event::Kind kind = Event::Kind::rayCast) {
        Event event;
        event.kind = kind;
        event.ask = ask;
        event.a = origin;
        event.b = direction;
        answer.events.push_back(event);
    }
    [[nodiscard]] ShadowLog read() const { return readShadowLog(question, answer); }
};

TEST(ShadowLog, SortsRaysByPointAndByLight) {
    Logged logged;
    logged.cast(0, {0.0, 1e-4, 0.0}, {0.1, 4.0, 0.0});
    logged.cast(0, {0.0, 1e-4, 0.0}, {4.1, 4.0, 0.0});
    logged.cast(0, {0.0, 1e-4, 0.0}, {3.9, 4.0, 0.0});
    logged.cast(1, {1.0, 1e-4, 0.0}, {-1.0, 4.0, 0.1});
    const ShadowLog log = logged.read();
    ASSERT_EQ(log.points.size(), 2U);
    EXPECT_EQ(log.points[0].lines[0].size(), 1U);
    EXPECT_EQ(log.points[0].lines[1].size(), 2U);
    EXPECT_EQ(log.points[0].lineCount(), 3U);
    EXPECT_EQ(log.points[1].lines[0].size(), 1U);
    EXPECT_EQ(log.points[1].zones[1], Zone::umbra);
    EXPECT_EQ(log.points[0].colour, (ColourRGB{0.1, 0.2, 0.3}));
    EXPECT_EQ(log.points[1].colour, ColourRGB{}) << "no answer";
    EXPECT_NEAR(log.points[1].lines[0][0].miss, 0.1, 1e-3);
    EXPECT_EQ(log.points[1].lines[0][0].toLight, Sight::open);
}

// Code whose ray meets its own surface casts it again from behind that hit. A ray from the same
// start, or from an earlier one, is another sample.
TEST(ShadowLog, TakesARayThatGoesOnBesideItsStartForOneSample) {
    const Vector3 direction{0.1, 4.0, 0.0};
    Logged logged;
    logged.cast(0, {0.0, 0.0, 0.0}, direction);
    logged.cast(0, {0.0, 1e-4, 0.0}, direction);
    logged.cast(0, {0.0, 1e-4, 0.0}, direction);
    logged.cast(0, {0.0, 0.0, 0.0}, direction);
    logged.cast(0, {0.0, 1e-4, 0.0}, direction);
    logged.cast(0, {0.0, 1e-4, 0.0}, {0.2, 4.0, 0.0});
    logged.cast(0, {0.0, 1e-1, 0.0}, {0.2, 4.0, 0.0});
    const ShadowLog log = logged.read();
    const std::vector<AimLine>& lines = log.points[0].lines[0];
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0].origin.y, 1e-4) << "the ray that goes on decides";
}

TEST(ShadowLog, KnowsARayThatRunsFromTheLightToThePoint) {
    Logged logged;
    logged.cast(0, {0.1, 4.0, 0.0}, {-0.1, -4.0 + 1e-4, 0.0});
    logged.cast(0, {0.0, 1e-4, 0.0}, {0.1, 4.0, 0.0});
    const ShadowLog log = logged.read();
    const std::vector<AimLine>& lines = log.points[0].lines[0];
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_TRUE(lines[0].isReversed);
    EXPECT_FALSE(lines[1].isReversed);
}

TEST(ShadowLog, LeavesOutWhatIsNoRay) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    Logged logged;
    for (const Vector3& odd : {Vector3{nan, 1.0, 0.0}, Vector3{0.0, nan, 0.0},
                               Vector3{0.0, 1.0, nan}, Vector3{0.0, endless, 0.0}}) {
        logged.cast(0, odd, {0.0, 1.0, 0.0});
        logged.cast(0, {0.0, 1e-4, 0.0}, odd);
    }
    logged.cast(0, {0.0, 1e-4, 0.0}, {});
    logged.cast(0, {0.0, 1e-4, 0.0}, {1e200, 1e200, 0.0});
    logged.cast(2, {0.0, 1e-4, 0.0}, {0.0, 1.0, 0.0});
    logged.cast(0, {0.0, 1e-4, 0.0}, {0.0, 1.0, 0.0}, Event::Kind::traceBegan);
    EXPECT_EQ(logged.read().points[0].lineCount(), 0U);
    EXPECT_EQ(logged.read().points[1].lineCount(), 0U);
}

TEST(ShadowLog, EndsBeforeThePointAtWhichItIsCut) {
    Logged logged;
    logged.cast(0, {0.0, 1e-4, 0.0}, {0.0, 1.0, 0.0});
    logged.cast(1, {1.0, 1e-4, 0.0}, {0.0, 1.0, 0.0});
    EXPECT_EQ(logged.read().points.size(), 2U);
    logged.answer.eventsCut = true;
    EXPECT_EQ(logged.read().points.size(), 1U);
    EXPECT_TRUE(logged.read().cut);
    logged.answer.events.back().ask = 7;
    EXPECT_EQ(logged.read().points.size(), 2U) << "a claim that cannot be";
    logged.answer.events.clear();
    EXPECT_EQ(logged.read().points.size(), 2U);
}

}  // namespace
}  // namespace ticker::tasks
