#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

TEST(CheckFinite, WantsANumberInEveryChannel) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const ColourRGB& odd :
         {ColourRGB{nan, 0.0, 0.0}, ColourRGB{0.0, nan, 0.0}, ColourRGB{0.0, 0.0, nan}}) {
        ShadowByHand made;
        made.ask(Purpose::planeShadow);
        made.point().colour = {0.5, 0.5, 0.5};
        EXPECT_FALSE(checkFinite(made.logs()));
        made.point().colour = odd;
        EXPECT_EQ(idOf(checkFinite(made.logs())), "shadow.wrong");
    }
}

// Only infinities of both signs cancel to NaN in a sum. Those of one sign must be found, too.
TEST(CheckFinite, IsNotMisledByInfinitiesOfOneSign) {
    const double endless = std::numeric_limits<double>::infinity();
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    made.point().colour = {endless, endless, endless};
    EXPECT_TRUE(checkFinite(made.logs()));
}

std::optional<Finding> judgeDirections(int away) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    made.point({1.0, 0.0, 0.0});
    for (int i = 0; i < 10; ++i)
        made.cast(i < away ? Vector3{2.0, -6.0, 0.1 * i} : Vector3{0.0, 6.0, 0.1 * i});
    return checkBackwards(made.logs());
}

TEST(CheckBackwards, WantsRaysToLeaveTowardsTheLight) {
    EXPECT_FALSE(judgeDirections(0));
    EXPECT_FALSE(judgeDirections(5));
    const auto backwards = judgeDirections(10);
    ASSERT_EQ(idOf(backwards), "shadow.wrong");
    EXPECT_NE(backwards->message.find("10 of 10"), std::string::npos);
    EXPECT_NE(backwards->hint.find("target - start"), std::string::npos);
}

std::optional<Finding> judgeStarts(const Vector3& first, const Vector3& second) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    made.point({1.0, 0.0, 0.0});
    made.cast({0.0, 6.0, 0.0}, 0, first);
    made.cast({0.0, 6.0, 0.1}, 0, second);
    return checkStarts(made.logs());
}

TEST(CheckStarts, WantsRaysToStartAtThePoint) {
    EXPECT_FALSE(judgeStarts({0.0, 1.49e-3, 0.0}, {0.0, 0.0, 1.49e-3}));
    const auto jittered = judgeStarts({0.0, 1e-3, 0.0}, {0.3, 1e-3, 0.0});
    ASSERT_EQ(idOf(jittered), "shadow.point-jittered");
    EXPECT_NEAR(numberIn(*jittered, "spreadOfStarts"), 0.3, 1e-9);
    EXPECT_NEAR(numberIn(*jittered, "farthestStart"), std::hypot(0.3, 1e-3), 1e-9);
    const auto far = judgeStarts({0.0, 0.1, 0.0}, {0.0, 0.1, 0.0});
    ASSERT_EQ(idOf(far), "shadow.wrong");
    EXPECT_NE(far->hint.find("kShadowBias"), std::string::npos);
    EXPECT_EQ(far->hint.find("start there"), std::string::npos);
    const auto atViewer = judgeStarts({-1.0, 3.0, -1.0}, {-1.0, 3.0, -1.0});
    ASSERT_EQ(idOf(atViewer), "shadow.wrong");
    EXPECT_NE(atViewer->hint.find("start there"), std::string::npos) << atViewer->hint;
    EXPECT_NE(jittered->hint.find("belongs to their target"), std::string::npos);
    EXPECT_EQ(idOf(judgeStarts({0.0, 1.51e-3, 0.0}, {0.0, 1.51e-3, 0.0})), "shadow.wrong");
}

TEST(CheckSmallPool, WarnsWhereManyRaysShareAFewAims) {
    AimVerdict aims;
    aims.lines = 2010;
    aims.distinct = 13;
    const auto pool = checkSmallPool(aims);
    ASSERT_EQ(idOf(pool), "shadow.fixed-samples");
    EXPECT_EQ(pool->severity, Severity::warn);
    EXPECT_NE(pool->message.find("of 2010 rays about 13 have"), std::string::npos);
    aims.distinct = 64;
    EXPECT_FALSE(checkSmallPool(aims));
    EXPECT_FALSE(checkSmallPool({})) << "without rays nothing can be said";
}

/// Points that all aim at the same `distinct` places, except the last two, which are `moved` away.
std::optional<Finding> judgeFixed(int points, int distinct, double moved, double apart = 0.2) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    for (int i = 0; i < points; ++i) {
        made.point({apart * i, 0.0, 0.07 * apart * i * i});
        for (int ray = 0; ray < 10; ++ray) {
            const double off = 0.03 * (ray % distinct) + (i + 2 >= points ? moved : 0.0);
            made.cast({0.2 - off, 6.0 + 0.02 * (ray % distinct), off});
        }
    }
    return checkFixedSamples(made.logs());
}

TEST(CheckFixedSamples, FindsAimsThatAreTheSameAtAllPoints) {
    const auto fixed = judgeFixed(10, 10, 0.0);
    ASSERT_EQ(idOf(fixed), "shadow.fixed-samples");
    EXPECT_EQ(fixed->severity, Severity::warn);
    EXPECT_EQ(numberIn(*fixed, "distinctAims"), 10.0);
    EXPECT_EQ(judgeFixed(10, 2, 0.0)->severity, Severity::fail);
    EXPECT_EQ(judgeFixed(10, 3, 0.0)->severity, Severity::warn);
    EXPECT_NE(judgeFixed(10, 1, 0.0)->hint.find("divide as double"), std::string::npos);
    EXPECT_EQ(judgeFixed(10, 2, 0.0)->hint.find("divide as double"), std::string::npos);
    EXPECT_FALSE(judgeFixed(10, 10, 0.02));
    EXPECT_TRUE(judgeFixed(9, 10, 0.0)) << "eight to compare";
    EXPECT_FALSE(judgeFixed(8, 10, 0.0)) << "too few";
    EXPECT_FALSE(judgeFixed(10, 10, 0.0, 0.005)) << "too close together to tell";
}

TEST(CheckFixedSamples, ComparesPointsByHowFarTheyAreApartNotByWhereTheyAre) {
    const auto judgeAround = [](const Vector3& middle, double apart) {
        ShadowByHand made;
        made.ask(Purpose::oneLight);
        for (int i = 0; i < 10; ++i) {
            made.point(middle + Vector3{apart * (i - 5), 0.0, 0.02 * apart * i});
            for (int ray = 0; ray < 10; ++ray)
                made.cast({0.03 * ray, 6.0 + 0.02 * ray, 0.1});
        }
        return checkFixedSamples(made.logs());
    };
    EXPECT_TRUE(judgeAround({}, 0.3));
    EXPECT_TRUE(judgeAround({3.0, 0.0, 2.0}, 0.3));
    EXPECT_FALSE(judgeAround({3.0, 0.0, 2.0}, 0.004));
}

TEST(CheckFixedSamples, WantsAsManyRaysEverywhere) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    for (int i = 0; i < 10; ++i) {
        made.point({0.2 * i, 0.0, 0.0});
        for (int ray = 0; ray < (i == 9 ? 9 : 10); ++ray)
            made.cast({0.03 * ray, 6.0, 0.2});
    }
    EXPECT_FALSE(checkFixedSamples(made.logs()));
    ShadowByHand none;
    none.ask(Purpose::oneLight);
    for (int i = 0; i < 10; ++i)
        none.point({0.2 * i, 0.0, 0.0});
    EXPECT_FALSE(checkFixedSamples(none.logs()));
}

std::optional<Finding> judgeGrowth(double near, double far) {
    ShadowByHand made;
    made.ask(Purpose::oneLight);
    made.point();
    made.cast({near, 6.0, 0.0});
    made.ask(Purpose::oneLight);
    made.point();
    made.cast({3.0, 6.0, 0.0});  // the first question counts
    made.ask(Purpose::farLight, {{0.0, 120.0, 0.0}});
    made.point();
    made.cast({far, 120.0, 0.0});
    return checkDirectionOffset(made.logs());
}

TEST(CheckDirectionOffset, FindsALightThatGrowsWithItsDistance) {
    const auto grown = judgeGrowth(0.4, 8.0);
    ASSERT_EQ(idOf(grown), "shadow.direction-offset");
    EXPECT_NEAR(numberIn(*grown, "widestNear"), 0.4, 0.01);
    EXPECT_NEAR(numberIn(*grown, "widestFar"), 8.0, 0.1);
    EXPECT_FALSE(judgeGrowth(0.4, 1.9)) << "less than five times";
    EXPECT_TRUE(judgeGrowth(0.4, 2.1));
    EXPECT_FALSE(judgeGrowth(0.1, 0.79)) << "less than two radii";
    EXPECT_TRUE(judgeGrowth(0.1, 0.81));
}

std::string judgeAim(const AimVerdict& aims) {
    ShadowByHand made;
    made.ask(Purpose::farLight);
    made.point();
    made.castArc(3);
    return idOf(checkAims(made.logs(), aims));
}

TEST(CheckAims, NamesWhatTheVerdictSays) {
    AimVerdict right;
    right.lines = 10;
    right.shape = right.scaledShape = AimShape::ball;
    EXPECT_EQ(judgeAim(right), "");
    const auto with = [&](auto change) {
        AimVerdict aims = right;
        change(aims);
        return judgeAim(aims);
    };
    EXPECT_EQ(with([](AimVerdict& a) { a.together = true; }), "shadow.not-a-ball");
    EXPECT_EQ(with([](AimVerdict& a) { a.offCentre = true; }), "shadow.not-a-ball");
    EXPECT_EQ(with([](AimVerdict& a) { a.shape = a.scaledShape = {}; }), "shadow.not-a-ball");
    EXPECT_EQ(with([](AimVerdict& a) { a.scaledShape = {}; }), "") << "it fits as it is";
    EXPECT_EQ(with([](AimVerdict& a) { a.shape = {}; }), "shadow.light-size");
    EXPECT_EQ(with([](AimVerdict& a) { a.tooWide = true; }), "shadow.light-size");
    EXPECT_EQ(with([](AimVerdict& a) { a.huddled = true; }), "shadow.light-size");
    EXPECT_EQ(with([](AimVerdict& a) { a.shape = AimShape::polarHelper; }), "shadow.clustered");
    EXPECT_EQ(with([](AimVerdict& a) { a.shape = AimShape::surface; }), "");
    EXPECT_EQ(with([](AimVerdict& a) { a.lines = 0, a.together = true; }), "");
}

/// Asks for 14 rays to a light of radius 0.25.
/// @param off   Distance of the aims from the light's centre.
/// @param miss  Of the first ray; negative: as it is cast.
std::optional<Finding> judgeOther(int rays, double off, double colourTimes = 1.0,
                                  double miss = -1.0) {
    ShadowByHand made;
    ShadowQuestion& question = made.ask(Purpose::otherSettings);
    question.question.settings.shadowRayCount = 14;
    question.question.settings.lightSize = 0.25;
    PointLog& point = made.point();
    made.castArc(rays, 0, off);
    point.colour = (ambientPart(point, made.last().scene()) +
                    unshadowed(point, made.last().scene(), 0, false)) *
                   colourTimes;
    if (miss >= 0.0) point.lines[0][0].miss = miss;
    return checkOtherSettings(made.logs(), AimVerdict{});
}

TEST(CheckOtherSettings, WantsThemFollowed) {
    EXPECT_FALSE(judgeOther(14, 0.2));
    EXPECT_TRUE(judgeOther(13, 0.2));
    EXPECT_FALSE(judgeOther(14, 0.251)) << "the bias";
    EXPECT_FALSE(judgeOther(14, 0.2, 1.0, 0.25 + kLargestBias + 1e-7)) << "rounding";
    EXPECT_TRUE(judgeOther(14, 0.2, 1.0, 0.25 + kLargestBias + 4e-7));
    const auto wide = judgeOther(14, 0.26);
    ASSERT_EQ(idOf(wide), "settings.hard-coded");
    EXPECT_NEAR(numberIn(*wide, "widest"), 0.26, 1e-3);
    EXPECT_EQ(numberIn(*wide, "raysSeen"), 14.0);
    EXPECT_TRUE(judgeOther(14, 0.2, 1.5)) << "a value of no reading";
}

// Code that limits the radius is right for the handout's light, and no longer for larger ones.
TEST(CheckOtherSettings, WantsAWideLightToBeWide) {
    const auto judgeWide = [](double off, std::size_t distinct) {
        ShadowByHand made;
        ShadowQuestion& question = made.ask(Purpose::otherSettings, {{0.0, 8.0, 0.0}});
        question.question.settings.shadowRayCount = 15;
        question.question.settings.lightSize = 1.5;
        for (int i = 0; i < 30; ++i) {
            PointLog& point = made.point();
            made.castArc(15, 0, off);
            point.colour = ambientPart(point, made.last().scene()) +
                           unshadowed(point, made.last().scene(), 0, false);
        }
        AimVerdict aims;
        aims.distinct = distinct;
        return checkOtherSettings(made.logs(), aims);
    };
    EXPECT_FALSE(judgeWide(1.2, 2010));
    const auto narrow = judgeWide(1.0, 2010);
    ASSERT_EQ(idOf(narrow), "settings.hard-coded");
    EXPECT_NEAR(numberIn(*narrow, "widest"), 1.0, 0.02);
    EXPECT_FALSE(judgeWide(1.0, 10)) << "ten aims say little";
}

TEST(CheckOtherSettings, SaysThatMoreThanTheHandoutsRaysAreAccepted) {
    const auto says = [](int rays, const char* words) {
        const auto finding = judgeOther(rays, 0.2);
        return finding && finding->message.find(words) != std::string::npos;
    };
    EXPECT_TRUE(says(12, "more than the handout's 10 are accepted, but"));
    EXPECT_TRUE(says(10, "right with the handout's numbers, but"));
    EXPECT_FALSE(says(12, "right with the handout's numbers"));
}

}  // namespace
}  // namespace ticker::tasks
