#include <grader/tests/tasks/shadows/ReplayCase.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::tasks {
namespace {

TEST(Replay, SeesWhichRaysAreBlockedWhateverTheirLength) {
    ReplayCase half;
    half.answer({-0.3, -0.2, 0.2, 0.3}, {});
    ASSERT_EQ(half.log.points[0].lines[0].size(), 4U);
    EXPECT_EQ(half.log.points[0].lines[0][0].toLight, Sight::open);
    EXPECT_EQ(half.log.points[0].lines[0][3].toLight, Sight::blocked);
    EXPECT_NEAR(half.log.points[0].lines[0][0].miss, 0.3 * 4.0 / std::hypot(0.3, 4.0), 1e-4);
}

TEST(Replay, FitsHalfOfTheLightAndNothingElse) {
    ReplayCase half;
    half.answer({-0.3, -0.2, 0.2, 0.3}, kAmbient + (kDiffuse + kSpecular) * 0.5);
    EXPECT_TRUE(half.fitsAs(ShadowArithmetic::right));
    EXPECT_FALSE(half.fitsAs(ShadowArithmetic::ambientScaled));
    EXPECT_FALSE(half.fitsAs(ShadowArithmetic::litIfAny));
    half.answer({-0.3, -0.2, 0.2, 0.3}, kAmbient + (kDiffuse + kSpecular) * 0.6);
    EXPECT_FALSE(half.fitsAs(ShadowArithmetic::right));
}

TEST(Replay, NamesEachMistakeOfArithmetic) {
    ReplayCase quarter;
    const std::vector<double> aims{-0.3, 0.2, 0.25, 0.3};
    quarter.answer(aims, (kAmbient + kDiffuse + kSpecular) * 0.25);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::ambientScaled));
    quarter.answer(aims, kAmbient + kDiffuse * 0.25 + kSpecular);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::specularUnshadowed));
    quarter.answer(aims, kAmbient + kDiffuse + kSpecular * 0.25);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::diffuseUnshadowed));
    quarter.answer(aims, kAmbient + (kDiffuse + kSpecular) * 0.75);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::inverted));
    quarter.answer(aims, kAmbient);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::litIfAll));
    EXPECT_FALSE(quarter.fitsAs(ShadowArithmetic::right));
}

TEST(Replay, TurnsRaysRoundThatWereCastFromTheLight) {
    ReplayCase reversed;
    probe::IlluminateAnswer given;
    given.state = probe::AnswerState::answered;
    given.colours = {kAmbient};
    probe::Event event;
    event.kind = probe::Event::Kind::rayCast;
    event.a = {0.3, 4.0, 0.0};
    event.b = {-0.3, -4.0, 0.0};
    given.events = {event};
    reversed.log = readShadowLog(reversed.question, given);
    ASSERT_EQ(reversed.log.points[0].lines[0].size(), 1U);
    EXPECT_NEAR(reversed.log.points[0].lines[0][0].origin.magnitude(), 1e-4, 1e-9);
    EXPECT_EQ(reversed.log.points[0].lines[0][0].toLight, Sight::blocked);
}

TEST(Replay, KnowsAmbientLightThatIsThereForEachLight) {
    ReplayCase made;
    made.question.question.scene.pointLights.push_back(
        made.question.question.scene.pointLights.front());
    made.question.zones = {{Zone::penumbra, Zone::penumbra}};
    const ColourRGB half = (kDiffuse + kSpecular) * 0.5;
    made.answer({-0.3, -0.2, 0.5, 0.6}, kAmbient * 2.0 + half);
    made.log.points[0].lines[1] = made.log.points[0].lines[0];
    made.log.points[0].colour = kAmbient * 2.0 + half * 2.0;
    EXPECT_TRUE(made.fitsAs(ShadowArithmetic::ambientForEachLight));
    EXPECT_FALSE(made.fitsAs(ShadowArithmetic::right));
}

}  // namespace
}  // namespace ticker::tasks
