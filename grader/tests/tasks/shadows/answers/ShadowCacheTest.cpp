#include <grader/tasks/shadows/answers/ShadowCache.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

constexpr std::size_t kAsked = 10;

// Points of a floor under a ball that hides one side of the light. A point's rays are written as
// the sides that they aim at.
class UnderABall {
public:
    enum class Side { open, hidden };

    UnderABall() { ask(); }
    void ask() {
        raytracer::SphereDescription ball;
        ball.centre = {-1.0, 3.0, 0.0};
        ball.radius = 0.95;
        made_.ask(Purpose::oneLight).question.scene.spheres.push_back(ball);
    }
    void point(std::initializer_list<Side> rays) {
        made_.point();
        double turn = 0.0;
        for (const Side side : rays) {
            turn += 0.01;
            AimLine& line = made_.cast({side == Side::open ? 0.2 : -0.3, 6.0, turn});
            if (side == Side::hidden) line.toLight = line.endlessly = Sight::blocked;
        }
    }
    void points(int count, std::initializer_list<Side> rays) {
        for (int i = 0; i < count; ++i)
            point(rays);
    }
    [[nodiscard]] const ShadowLog& last() { return made_.last(); }

private:
    ShadowByHand made_;
};

constexpr auto kOpen = UnderABall::Side::open;
constexpr auto kHidden = UnderABall::Side::hidden;

TEST(ShadowCacheRays, AreAddedAsBlockedWhereTheirBlockerHasBlockedAnotherRay) {
    UnderABall made;
    made.points(4, {kOpen, kHidden, kOpen, kOpen});
    const auto whole = withCachedRays(std::vector{made.last()});
    ASSERT_TRUE(whole);
    for (const PointLog& point : whole->front().points) {
        ASSERT_EQ(point.lines[0].size(), kAsked);
        EXPECT_EQ(std::ranges::count(point.lines[0], Sight::blocked, &AimLine::toLight), 7);
        EXPECT_EQ(std::ranges::count(point.lines[0], true, &AimLine::isAdded), 6);
    }
}

TEST(ShadowCacheRays, AreAddedForALightWithoutRaysOnceSomethingWasBlocked) {
    UnderABall made;
    made.points(4, {kOpen, kHidden, kOpen, kOpen});
    made.point({});
    const auto whole = withCachedRays(std::vector{made.last()});
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->front().points.back().lines[0].size(), kAsked);
}

TEST(ShadowCacheRays, DoNotExplainALoopThatEndsAtTheFirstBlockedRay) {
    UnderABall made;
    made.points(20, {kOpen, kOpen, kHidden});
    EXPECT_FALSE(withCachedRays(std::vector{made.last()}));
}

TEST(ShadowCacheRays, DoNotExplainASecondRayThatMeetsTheSameObject) {
    UnderABall made;
    made.points(4, {kOpen, kHidden, kOpen, kOpen});
    made.point({kHidden, kHidden, kOpen});
    EXPECT_FALSE(withCachedRays(std::vector{made.last()}));
}

TEST(ShadowCacheRays, MayFollowARayThatMeetsTheSameObjectWhereEveryRayWasCast) {
    UnderABall made;
    made.points(4, {kOpen, kHidden, kOpen, kOpen});
    made.point({kHidden, kHidden, kHidden, kHidden, kHidden, kOpen, kOpen, kOpen, kOpen, kOpen});
    const auto whole = withCachedRays(std::vector{made.last()});
    ASSERT_TRUE(whole);
    EXPECT_EQ(std::ranges::count(whole->front().points.back().lines[0], true, &AimLine::isAdded),
              0);
}

TEST(ShadowCacheRays, DoNotExplainMissingRaysWhereNothingWasBlocked) {
    UnderABall made;
    made.points(4, {kOpen, kHidden, kOpen, kOpen});
    const ShadowLog right = made.last();
    made.ask();
    made.point({kOpen, kOpen, kOpen});
    EXPECT_FALSE(withCachedRays(std::vector{right, made.last()}));
}

TEST(ShadowCacheRays, AreNotTakenFromThreePlacesAlone) {
    UnderABall made;
    made.points(3, {kOpen, kHidden, kOpen, kOpen});
    EXPECT_FALSE(withCachedRays(std::vector{made.last()}));
}

TEST(ShadowCacheRays, AreAsManyAsAPointInPlainSightHas) {
    UnderABall made;
    made.points(4, {kOpen, kHidden, kOpen, kOpen});
    made.point(
        {kOpen, kOpen, kOpen, kOpen, kOpen, kOpen, kOpen, kOpen, kOpen, kOpen, kOpen, kOpen});
    const auto whole = withCachedRays(std::vector{made.last()});
    ASSERT_TRUE(whole);
    for (const PointLog& point : whole->front().points)
        EXPECT_EQ(point.lines[0].size(), 12U);
}

TEST(ShadowCacheRays, CountAsDifferentRays) {
    UnderABall made;
    made.points(1, {kOpen, kHidden, kOpen, kOpen});
    const ShadowLog whole = withCachedRays(made.last());
    EXPECT_EQ(countRays({&whole}).fewestDistinct, kAsked);
    EXPECT_EQ(countRays({&whole}).repeating, 0U);
}

}  // namespace
}  // namespace ticker::tasks
