#include <grader/tests/tasks/shadows/ReplayCase.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

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

TEST(Replay, FitsAsAWholeWhereEveryPointDoes) {
    ReplayCase made;
    made.answer({-0.3, -0.2, 0.2, 0.3}, kAmbient + (kDiffuse + kSpecular) * 0.5);
    EXPECT_TRUE(allFit(made.log, {}, ShadowArithmetic::right));
    EXPECT_TRUE(fitsAnyReading(made.log));
    made.log.points.push_back(made.log.points[0]);
    made.log.points[1].colour = kAmbient;
    EXPECT_FALSE(allFit(made.log, {}, ShadowArithmetic::right));
    EXPECT_FALSE(fitsAnyReading(made.log));
    EXPECT_EQ(countFits(made.log, {}, ShadowArithmetic::right).fitting, 1U);
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

TEST(Replay, AllowsItsToleranceInEveryChannelOnBothSides) {
    const ColourRGB right = kAmbient + (kDiffuse + kSpecular) * 0.5;
    const auto fitsWith = [&](const ColourRGB& change) {
        ReplayCase made;
        made.answer({-0.3, -0.1, 0.15, 0.3}, right + change);
        return made.fitsAs(ShadowArithmetic::right);
    };
    ReplayCase made;
    made.answer({-0.3, -0.1, 0.15, 0.3}, right);
    const ColourRGB slack = toleranceAt(made.log.points[0], made.log.scene(), false);
    const std::array<ColourRGB, 3> channels{
        ColourRGB{slack.r, 0.0, 0.0}, ColourRGB{0.0, slack.g, 0.0}, ColourRGB{0.0, 0.0, slack.b}};
    for (const ColourRGB& channel : channels)
        for (const double side : {-1.0, 1.0}) {
            EXPECT_TRUE(fitsWith(channel * (0.8 * side)));
            EXPECT_FALSE(fitsWith(channel * (1.3 * side)));
        }
}

TEST(Replay, DecidesByWhetherAnyHalfOrAllOfTheRaysArrive) {
    const ColourRGB full = kDiffuse + kSpecular;
    const auto fits = [](const std::vector<double>& aims, const ColourRGB& colour,
                         ShadowArithmetic arithmetic) {
        ReplayCase made;
        made.answer(aims, colour);
        return made.fitsAs(arithmetic);
    };
    const std::vector<std::vector<double>> byNumberOpen{{0.15, 0.2, 0.25, 0.3},
                                                        {-0.3, 0.2, 0.25, 0.3},
                                                        {-0.3, -0.2, 0.2, 0.3},
                                                        {-0.3, -0.2, -0.1, 0.3},
                                                        {-0.3, -0.2, -0.1, -0.15}};
    for (std::size_t open = 0; open < byNumberOpen.size(); ++open) {
        SCOPED_TRACE(open);
        const std::vector<double>& aims = byNumberOpen[open];
        const double share = static_cast<double>(open) / 4.0;
        const auto onlyIf = [](bool holds) { return holds ? 1.0 : 0.0; };
        const ColourRGB any = kAmbient + kDiffuse * share + kSpecular * onlyIf(open > 0);
        EXPECT_TRUE(fits(aims, any, ShadowArithmetic::specularIfAny));
        EXPECT_EQ(fits(aims, any, ShadowArithmetic::right), open == 0 || open == 4);
        EXPECT_EQ(fits(aims, kAmbient + full, ShadowArithmetic::litIfAny), open > 0);
        EXPECT_EQ(fits(aims, kAmbient + full, ShadowArithmetic::litIfAll), open == 4);
        EXPECT_EQ(fits(aims, kAmbient, ShadowArithmetic::litIfAll), open < 4);
        EXPECT_EQ(fits(aims, kAmbient + full, ShadowArithmetic::litIfHalf), open >= 2);
        EXPECT_EQ(fits(aims, kAmbient, ShadowArithmetic::litIfHalf), open <= 2);
    }
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
