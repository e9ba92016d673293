#include <grader/tests/tasks/lens/LensByHand.h>

#include <gtest/gtest.h>

namespace ticker::tasks {
namespace {

/// A pixel of `rays` rays from `origins` different points.
void add(LensByHand& lens, int rays, int origins) {
    LensPixel& pixel = lens.pixel();
    for (int i = 0; i < rays; ++i)
        pixel.rays.push_back(rayThrough({0.01 * (1 + i % origins), 0.0, 0.0}, {0.0, 0.0, 3.5}));
}

std::optional<Finding> judgeCounts(int rays, int origins, bool cut = false) {
    LensByHand lens;
    add(lens, 50, 50);
    add(lens, rays, origins);
    lens.log.cut = cut;
    return checkLensCounts(lens.log);
}

TEST(LensCounts, AreThoseThatWereAskedForOrMore) {
    EXPECT_FALSE(judgeCounts(50, 50));
    EXPECT_FALSE(judgeCounts(70, 50));
    const auto few = judgeCounts(49, 49);
    ASSERT_EQ(idOf(few), "dof.too-few-rays");
    EXPECT_EQ(numberIn(*few, "fewestRays"), 49.0);
    EXPECT_EQ(numberIn(*few, "raysExpected"), 50.0);
    EXPECT_FALSE(judgeCounts(49, 49, true)) << "the log ends there";
}

TEST(LensCounts, SayWhereOnlySomePixelsHaveTooFew) {
    LensByHand lens;
    add(lens, 50, 50);
    add(lens, 12, 12);
    add(lens, 1, 1);
    const auto some = checkLensCounts(lens.log);
    ASSERT_EQ(idOf(some), "dof.too-few-rays");
    EXPECT_NE(some->message.find("for 2 of 3 pixels, the first in column 1, row 0, there are 1 to "
                                 "12"),
              std::string::npos)
        << some->message;
    EXPECT_NE(some->hint.find("leave the loop early"), std::string::npos);
    lens.log.pixels.erase(lens.log.pixels.begin());
    const auto all = checkLensCounts(lens.log);
    EXPECT_NE(all->message.find("expected; there are 1 to 12."), std::string::npos) << all->message;
    EXPECT_NE(judgeCounts(1, 1)->message.find("there is 1."), std::string::npos);
}

TEST(LensCounts, WantDifferentPointsOfTheLens) {
    EXPECT_FALSE(judgeCounts(50, 26)) << "a coarse generator gives some twice";
    const auto coarse = judgeCounts(50, 25);
    ASSERT_EQ(idOf(coarse), "dof.shared-samples");
    EXPECT_EQ(numberIn(*coarse, "fewestDistinctOrigins"), 25.0);
    EXPECT_NE(coarse->hint.find("coarse"), std::string::npos);
    EXPECT_NE(judgeCounts(50, 3)->hint.find("coarse"), std::string::npos);
    EXPECT_EQ(judgeCounts(50, 2)->hint.find("coarse"), std::string::npos);
}

TEST(LensCounts, FindNoLensWhereEveryRayStartsAtTheEye) {
    LensByHand lens;
    for (int i = 0; i < 50; ++i)
        lens.pixel().rays = {rayThrough({0.9e-7, 0.0, 0.0}, {0.0, 0.0, 1.0})};
    EXPECT_EQ(idOf(checkLensCounts(lens.log)), "dof.none");
    lens.log.pixels.front().rays = {rayThrough({1.1e-7, 0.0, 0.0}, {0.0, 0.0, 1.0})};
    EXPECT_EQ(idOf(checkLensCounts(lens.log)), "dof.too-few-rays");
}

/// Pixels of `ofLens` rays from the lens and one from the eye.
LensByHand& addWithEye(LensByHand& lens, int ofLens, bool samePattern = false, int pixels = 12) {
    for (int pixel = 0; pixel < pixels; ++pixel) {
        add(lens, ofLens, ofLens);
        std::vector<LensRay>& rays = lens.log.pixels.back().rays;
        rays.push_back(rayThrough({}, {0.0, 0.0, 3.5}));
        if (!samePattern) rays.front() = rayThrough({0.0, 0.1 + pixel, 0.0}, {0.0, 0.0, 3.5});
    }
    return lens;
}

TEST(LensCounts, CountARayFromTheEyeOnlyBesideAllRaysOfTheLens) {
    LensByHand among;
    const auto finding = checkLensCounts(addWithEye(among, 49).log);
    ASSERT_EQ(idOf(finding), "dof.too-few-rays");
    EXPECT_NE(finding->message.find("1 of the 50 rays starts exactly at the eye"),
              std::string::npos)
        << finding->message;
    EXPECT_NE(finding->hint.find("out of the sum"), std::string::npos);
    LensByHand beside;
    EXPECT_FALSE(checkLensCounts(addWithEye(beside, 50).log));
    LensByHand pattern;
    EXPECT_FALSE(checkLensCounts(addWithEye(pattern, 49, true).log)) << "a pattern with the eye";
    LensByHand cut;
    addWithEye(cut, 49).log.cut = true;
    EXPECT_FALSE(checkLensCounts(cut.log));
    LensByHand once;
    addWithEye(once, 49).log.pixels.front().rays.back().origin = {0.3, 0.0, 0.0};
    EXPECT_FALSE(checkLensCounts(once.log)) << "one random point may be the eye";
    LensByHand single;
    EXPECT_FALSE(checkLensCounts(addWithEye(single, 49, false, 1).log))
        << "that of a picture of one pixel as well, for code that draws from a grid";
}

TEST(LensCounts, TellPixelsWithoutALens) {
    LensByHand lens;
    add(lens, 50, 50);
    lens.pixel().rays.assign(50, rayThrough({}, {0.0, 0.0, 3.5}));
    const auto some = checkLensCounts(lens.log);
    ASSERT_EQ(idOf(some), "dof.shared-samples");
    EXPECT_NE(some->message.find("in 1 of 2 pixels, the first in column 1, row 0"),
              std::string::npos)
        << some->message;
    add(lens, 50, 2);
    EXPECT_EQ(checkLensCounts(lens.log)->message.find("at the eye"), std::string::npos);
}

TEST(LensBounces, AreThoseOfTheSettings) {
    const auto judge = [](int bounces) {
        LensByHand lens;
        lens.asked.settings.bounces = 3;
        add(lens, 2, 2);
        lens.log.pixels[0].rays[0].bounces = 3;
        lens.log.pixels[0].rays[1].bounces = bounces;
        return idOf(checkBounces(lens.log));
    };
    EXPECT_EQ(judge(3), "");
    EXPECT_EQ(judge(-1), "") << "another recursion";
    EXPECT_EQ(judge(2), "dof.wrong");
    EXPECT_EQ(judge(0), "dof.wrong");
}

TEST(LensBounces, AreSaidAsTheyAre) {
    LensByHand lens;
    lens.asked.settings.bounces = 2;
    for (int pixel = 0; pixel < 2; ++pixel) {
        add(lens, 50, 50);
        for (LensRay& ray : lens.log.pixels.back().rays)
            ray.bounces = 0;
    }
    EXPECT_NE(checkBounces(lens.log)->message.find("they are traced with 0."), std::string::npos);
    std::vector<LensRay>& counted = lens.log.pixels[1].rays;
    lens.log.pixels[0].rays = counted;
    for (LensRay& ray : lens.log.pixels[0].rays)
        ray.bounces = 2;
    counted[0].bounces = 2;
    counted[1].bounces = 1;
    const auto some = checkBounces(lens.log);
    EXPECT_NE(
        some->message.find("in column 1, row 0 they are traced with 2, 1, 0, 0, 0 and so on."),
        std::string::npos)
        << some->message;
    EXPECT_NE(some->hint.find("counted down"), std::string::npos);
}

TEST(LensPattern, IsReusedWhereAllPixelsOfARepetitionHaveTheSamePoints) {
    LensByHand lens;
    for (int i = 0; i < 3; ++i)
        add(lens, 5, 5);
    EXPECT_EQ(idOf(checkPattern(lens.log)), "dof.reused-pattern");
    for (int i = 0; i < 2; ++i) {
        add(lens, 4, 4);
        lens.log.pixels.back().repetition = 1;
    }
    EXPECT_EQ(idOf(checkPattern(lens.log)), "dof.reused-pattern") << "another in each repetition";
    add(lens, 5, 5);
    lens.log.pixels.back().repetition = 1;
    EXPECT_EQ(idOf(checkPattern(lens.log)), "");
}

TEST(LensPattern, IsReusedWhereRowsShareTheirPoints) {
    LensByHand lens;
    for (int row = 0; row < 3; ++row)
        for (int x = 0; x < 4; ++x)
            add(lens, 5, 5 - row);
    const auto rows = checkPattern(lens.log);
    ASSERT_EQ(idOf(rows), "dof.reused-pattern");
    EXPECT_NE(rows->message.find("3 patterns for 12 pixels"), std::string::npos);
}

TEST(LensPattern, IsNotReusedByAFewPixelsOrWhereNoRayIsSeen) {
    LensByHand lens;
    for (int origins = 1; origins <= 5; ++origins)
        add(lens, 5, origins);
    add(lens, 5, 5);
    EXPECT_EQ(idOf(checkPattern(lens.log)), "");
    LensByHand unseen;
    for (int i = 0; i < 8; ++i)
        unseen.pixel();
    EXPECT_EQ(idOf(checkPattern(unseen.log)), "");
}

}  // namespace
}  // namespace ticker::tasks
