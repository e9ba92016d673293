#include <grader/tasks/shadows/checks/UnexplainedShadows.h>
#include <grader/tests/tasks/shadows/KnownParts.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::tasks {
namespace {

/// Runs `check` on one point of a floor with one ray, whose colour is far off if `isOff`.
bool judgeOnePoint(bool (*check)(const std::vector<const ShadowLog*>&, bool), Zone zone,
                   Sight sight, bool isOff) {
    ShadowByHand made;
    made.ask(ShadowQuestion::Purpose::oneLight);
    PointLog& point = made.point();
    point.zones = {zone};
    const Parts parts = partsOf(point, made.last());
    const ColourRGB lit = parts.ambient + parts.diffuse + parts.specular;
    point.colour = (zone == Zone::lit) != isOff ? lit : parts.ambient;
    made.cast({0.0, 6.0, 0.0}).toLight = sight;
    return check(made.logs().oneLight, false);
}

TEST(ShadowsItself, IsABlockedRayAtADarkPointInFullLight) {
    const auto is = [](Zone zone, Sight sight, bool isOff) {
        return judgeOnePoint(shadowsItself, zone, sight, isOff);
    };
    EXPECT_TRUE(is(Zone::lit, Sight::blocked, true));
    EXPECT_TRUE(is(Zone::lit, Sight::unsure, true));
    EXPECT_FALSE(is(Zone::lit, Sight::open, true));
    EXPECT_FALSE(is(Zone::lit, Sight::blocked, false));
    EXPECT_FALSE(is(Zone::umbra, Sight::blocked, true));
}

TEST(LeaksAtTheStart, IsARayThatMeetsItsSurfaceAtALitPointInFullShadow) {
    const auto is = [](Zone zone, Sight sight, bool isOff) {
        return judgeOnePoint(leaksAtTheStart, zone, sight, isOff);
    };
    EXPECT_TRUE(is(Zone::umbra, Sight::unsure, true));
    EXPECT_FALSE(is(Zone::umbra, Sight::blocked, true));
    EXPECT_FALSE(is(Zone::umbra, Sight::unsure, false));
    EXPECT_FALSE(is(Zone::lit, Sight::unsure, true));
}

/// The message about points at which two of four rays arrive, with these shares of the light.
std::string toldOf(const std::vector<double>& shares, const ColourRGB& tint = ColourRGB{0.0}) {
    ShadowByHand made;
    ShadowQuestion& asked = made.ask(ShadowQuestion::Purpose::oneLight);
    asked.question.scene.planes[0].material.colour = {0.1, 0.2, 0.9};
    asked.question.scene.planes[0].material.phongKS = 0.0;
    for (const double share : shares) {
        PointLog& point = made.point();
        point.zones = {Zone::penumbra};
        const Parts parts = partsOf(point, made.last());
        point.colour = parts.ambient + parts.diffuse * share + tint;
        for (int ray = 0; ray < 4; ++ray)
            made.cast({0.0, 6.0, 0.1 * ray}).toLight = ray < 2 ? Sight::open : Sight::blocked;
    }
    return unexplainedWithOneLight(made.logs().oneLight).message;
}

// The surface is blue, so that no channel can stand for another.
TEST(UnexplainedShadows, ComparesTheShareOfLightWithTheRaysThatArrive) {
    EXPECT_NE(
        toldOf({0.8}).find("Where 2 of 4 rays arrive, 0.5 of the light was expected, and there is "
                           "0.8 of it."),
        std::string::npos)
        << toldOf({0.8});
    EXPECT_NE(toldOf({0.4, 0.9, 0.6}).find("there is 0.9 of it"), std::string::npos)
        << "the point that is farthest off";
    EXPECT_EQ(toldOf({0.8}, {0.3, 0.0, 0.0}).find("rays arrive"), std::string::npos)
        << "no share of white light";
    EXPECT_EQ(toldOf({}).find("rays arrive"), std::string::npos);
}

TEST(UnexplainedShadows, SayWhenRaysRunFromTheLightToThePoint) {
    const auto told = [](bool isReversed) {
        ShadowByHand made;
        made.ask(ShadowQuestion::Purpose::oneLight);
        made.point();
        made.cast({0.0, 6.0, 0.0});
        made.cast({0.1, 6.0, 0.0}).isReversed = isReversed;
        return unexplainedShadows(made.logs().oneLight);
    };
    EXPECT_NE(told(true).message.find("They run from the light to the point."), std::string::npos);
    EXPECT_NE(told(true).hint.find("nearer by 1e-4"), std::string::npos);
    EXPECT_EQ(told(false).message.find("run from"), std::string::npos);
    EXPECT_EQ(told(false).hint.find("nearer by"), std::string::npos);
}

}  // namespace
}  // namespace ticker::tasks
