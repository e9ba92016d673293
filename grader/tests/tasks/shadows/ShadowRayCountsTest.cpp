#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

TEST(CountRays, TakesFewestMostAndDifferentOnesOverThePointsThatFaceTheLight) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    made.point();
    made.castArc(12);
    made.point({1.0, 0.0, 0.0});
    made.castArc(9);
    made.castArc(2);                                 // two of them again
    made.point({0.0, 6.0, 6.0}, {0.0, 1.0, 0.049});  // hardly faces it: towards is -z
    made.point({0.0, 6.0, -6.0}, Vector3{0.0, 1.0, 0.051}.normalised());
    made.castArc(10);
    const RayCounts counts = countRays({&made.last()});
    EXPECT_EQ(counts.fewest, 10U);
    EXPECT_EQ(counts.most, 12U);
    EXPECT_EQ(counts.fewestDistinct, 9U);
    EXPECT_EQ(counts.places, 3U);
    EXPECT_EQ(counts.repeating, 1U);
    EXPECT_FALSE(counts.allCentral);
}

TEST(CountRays, CountsLightsWithoutRaysOnlyWhereTold) {
    ShadowByHand made;
    made.ask(Purpose::severalLights, {{0.0, 6.0, 0.0}, {3.0, 6.0, 0.0}});
    made.point();
    made.castArc(10);
    EXPECT_EQ(countRays({&made.last()}).fewest, 0U);
    EXPECT_EQ(countRays({&made.last()}, false).fewest, 10U);
}

TEST(CountRays, TakesARayForCentralWithinItsBias) {
    const auto central = [](double off, double bias) {
        ShadowByHand made;
        made.ask(Purpose::oneLight);
        made.point();
        made.cast({off, 6.0, 0.0}, 0, {0.0, bias, 0.0});
        return countRays({&made.last()}).allCentral;
    };
    EXPECT_TRUE(central(1e-3, 1e-3));
    EXPECT_TRUE(central(1.0095e-3, 1e-3));
    EXPECT_FALSE(central(1.012e-3, 1e-3));
    EXPECT_TRUE(central(0.9e-7, 0.0));
    EXPECT_FALSE(central(2e-7, 0.0));
    EXPECT_TRUE(central(1.5e-3, 0.1));
    EXPECT_FALSE(central(1.6e-3, 0.1)) << "a bias that is too large allows no more";
}

TEST(RayCounts, RepeatWhereHalfAreEqualSomewhereOrSomeAtATenthOfThePlaces) {
    RayCounts counts;
    counts.places = 100;
    counts.repeating = 10;
    counts.fewestDistinct = 6;
    EXPECT_FALSE(counts.repeats(10));
    counts.repeating = 11;
    EXPECT_TRUE(counts.repeats(10));
    counts.repeating = 0;
    counts.fewestDistinct = 5;
    EXPECT_TRUE(counts.repeats(10));
}

/// Twenty points with ten rays each, then a point of a question of this purpose with `rays` rays,
/// of which `distinct` differ.
std::optional<Finding> judge(int rays, int distinct, bool fixed, double off = 0.2,
                             Purpose purpose = Purpose::oneLight) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    for (int i = 0; i < 20; ++i) {
        made.point({0.1 * i, 0.0, 0.0});
        made.castArc(10, 0, off);
    }
    made.ask(purpose);
    made.point();
    for (int i = 0; i < rays; ++i)
        made.cast(
            {off * std::cos(0.1 * (i % distinct)), 6.0, off * std::sin(0.1 * (i % distinct))});
    return checkRayCounts(made.logs(), fixed);
}

TEST(CheckRayCounts, SaysThatAShareIsKeptWherePointsGetNoRay) {
    const auto few = judge(9, 9, false);
    EXPECT_EQ(few->hint.find("another point"), std::string::npos);
    const auto none = judge(0, 1, false);
    ASSERT_EQ(idOf(none), "shadow.too-few-rays");
    EXPECT_NE(none->hint.find("keep no share from another point"), std::string::npos);
}

TEST(CheckRayCounts, WantsTenDifferentRaysAtEveryLight) {
    for (const Purpose purpose : {Purpose::oneLight, Purpose::beyondLight, Purpose::farLight}) {
        EXPECT_EQ(idOf(judge(10, 10, false, 0.2, purpose)), "");
        const auto few = judge(9, 9, false, 0.2, purpose);
        ASSERT_EQ(idOf(few), "shadow.too-few-rays");
        EXPECT_EQ(numberIn(*few, "fewestRays"), 9.0);
        EXPECT_EQ(numberIn(*few, "raysExpected"), 10.0);
    }
    EXPECT_EQ(idOf(judge(9, 9, false, 0.2, Purpose::severalLights)), "") << "looked at apart";
    EXPECT_EQ(idOf(judge(12, 12, false)), "");
    const auto copies = judge(10, 5, false);
    ASSERT_EQ(idOf(copies), "shadow.too-few-rays");
    EXPECT_EQ(numberIn(*copies, "fewestDistinctRays"), 5.0);
    EXPECT_EQ(idOf(judge(10, 5, true)), "") << "another finding";
    EXPECT_EQ(idOf(judge(10, 10, false, 0.0)), "shadow.hard");
}

TEST(CheckRayCounts, CallsOneRayAHardShadow) {
    for (const int rays : {1, 2}) {
        ShadowByHand made;
        made.ask(Purpose::oneLight);
        made.point();
        made.castArc(rays);
        EXPECT_EQ(idOf(checkRayCounts(made.logs(), false)),
                  rays == 1 ? "shadow.hard" : "shadow.too-few-rays");
    }
}

/// Three lights; the last gets `rays` rays, of which `distinct` differ.
std::optional<Finding> judgeSeveral(int rays, int distinct, bool fixed = false) {
    ShadowByHand made;
    made.ask(Purpose::severalLights, {{0.0, 6.0, 0.0}, {3.0, 6.0, 0.0}, {0.0, 6.0, 3.0}});
    made.point();
    made.castArc(10, 0);
    made.castArc(10, 1);
    for (int i = 0; i < rays; ++i)
        made.cast({0.2 * std::cos(0.1 * (i % distinct)), 6.0, 3.0}, 2);
    return checkSeveralCounts(made.logs(), fixed);
}

TEST(CheckSeveralCounts, WantsTenDifferentRaysToEachLightThatGetsAny) {
    EXPECT_FALSE(judgeSeveral(10, 10));
    EXPECT_FALSE(judgeSeveral(0, 1)) << "another finding";
    const auto few = judgeSeveral(9, 9);
    ASSERT_TRUE(few);
    EXPECT_EQ(numberIn(*few, "fewestRays"), 9.0);
    EXPECT_NE(few->message.find("10 shadow rays"), std::string::npos);
    EXPECT_NE(few->message.find("gets fewer rays: 9"), std::string::npos);
    const auto copies = judgeSeveral(10, 4);
    ASSERT_TRUE(copies);
    EXPECT_NE(copies->message.find("different"), std::string::npos);
    EXPECT_NE(copies->message.find("gets fewer different rays: 4"), std::string::npos);
    EXPECT_FALSE(judgeSeveral(10, 4, true));
    EXPECT_NE(judgeSeveral(6, 3)->message.find("gets fewer rays: 6"), std::string::npos);
}

/// Two lights, the second of which gets `rays` rays that pass it at `off`.
std::optional<Finding> judgeSizes(int rays, double off, std::size_t distinct = 2000) {
    ShadowByHand made;
    made.ask(Purpose::severalLights, {{0.0, 6.0, 0.0}, {3.0, 6.0, 0.0}});
    made.point();
    made.castArc(200, 0, 0.39);
    for (int i = 0; i < rays; ++i)
        made.cast(Vector3{3.0, 6.0, 0.0} + Vector3{0.0, 0.0, 1.0} * off, 1);
    AimVerdict aims;
    aims.distinct = distinct;
    return checkSeveralSizes(made.logs(), aims);
}

TEST(CheckSeveralSizes, WantsRaysNearTheRimAndNoneBeyond) {
    EXPECT_FALSE(judgeSizes(200, 0.39));
    EXPECT_FALSE(judgeSizes(200, 0.265)) << "beyond 0.65 of the radius 0.4";
    const auto narrow = judgeSizes(200, 0.255);
    ASSERT_EQ(idOf(narrow), "shadow.light-size");
    EXPECT_EQ(numberIn(*narrow, "light"), 1.0);
    EXPECT_NEAR(numberIn(*narrow, "widest"), 0.255, 1e-3);
    EXPECT_EQ(numberIn(*narrow, "widestExpected"), 0.4);
    EXPECT_TRUE(judgeSizes(170, 0.2));
    EXPECT_FALSE(judgeSizes(169, 0.2)) << "too few to tell";
    EXPECT_FALSE(judgeSizes(200, 0.2, 169)) << "too few that are independent";
    EXPECT_FALSE(judgeSizes(10, 0.4012)) << "the bias";
    EXPECT_TRUE(judgeSizes(10, 0.41));
}

TEST(CheckEveryLight, WantsRaysToAllThatThePointFaces) {
    ShadowByHand made;
    made.ask(Purpose::severalLights, {{0.0, 6.0, 0.0}, {3.0, -6.0, 0.0}});
    made.point();
    made.castArc(10);
    EXPECT_FALSE(checkEveryLight(made.logs()));
    made.point({0.0, -9.0, 0.0});
    made.castArc(10);
    EXPECT_EQ(idOf(checkEveryLight(made.logs())), "shadow.lights-mixed");
}

TEST(WidestMiss, IsTheLargestOfAllLights) {
    ShadowByHand made;
    made.ask(Purpose::severalLights, {{0.0, 6.0, 0.0}, {3.0, 6.0, 0.0}});
    made.point();
    made.castArc(3, 0, 0.1);
    made.cast({3.0, 6.0, 0.3}, 1);
    EXPECT_NEAR(widestMiss({&made.last()}), 0.3, 1e-3);
    EXPECT_EQ(widestMiss({}), 0.0);
}

}  // namespace
}  // namespace ticker::tasks
