#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::tasks {
namespace {

/// Twenty points with a light 0.1 above their floor, seen along the mirrored direction.
class Horizon {
public:
    Horizon() { made_.ask(ShadowQuestion::Purpose::horizon, {{4.0, 0.1, 0.0}}); }

    /// A point with this many rays above and below the horizon, and the light of this share.
    Horizon& add(int above, int below, double share) {
        PointLog& point = made_.point();
        point.point.viewer = {-4.0, 0.1, 0.0};
        for (int i = 0; i < above; ++i)
            made_.cast({4.0, 0.11 + 0.01 * i, 0.0});
        for (int i = 0; i < below; ++i)
            made_.cast({4.0, -0.11 - 0.01 * i, 0.0}).toLight = Sight::blocked;
        point.colour = ambientPart(point, made_.last().scene()) +
                       unshadowed(point, made_.last().scene(), 0, false) * share;
        return *this;
    }
    [[nodiscard]] std::optional<Finding> judge(std::size_t distinct = 2000) const {
        AimVerdict aims;
        aims.lines = 2010;
        aims.distinct = distinct;
        return checkHorizon(made_.logs(), aims, {});
    }

private:
    ShadowByHand made_;
};

TEST(CheckHorizon, AcceptsRaysBelowThatAreCastOrSpared) {
    EXPECT_FALSE(Horizon{}.add(6, 4, 0.6).add(7, 3, 0.7).judge());
    EXPECT_FALSE(Horizon{}.add(6, 0, 0.6).add(7, 0, 0.7).judge());
    EXPECT_FALSE(Horizon{}.add(6, 0, 6.0 / 16.0).judge()) << "more rays than asked for";
    EXPECT_FALSE(Horizon{}.add(0, 0, 0.0).judge());
}

TEST(CheckHorizon, FindsAShareOfTheRaysThatAreLeft) {
    const auto left = Horizon{}.add(10, 0, 1.0).add(8, 0, 1.0).add(6, 0, 1.0).judge();
    ASSERT_EQ(idOf(left), "shadow.wrong");
    EXPECT_NE(left->message.find("6 of 10 rays are above it"), std::string::npos) << left->message;
    EXPECT_FALSE(Horizon{}.add(8, 0, 1.0).add(6, 0, 0.6).judge()) << "not everywhere";
}

TEST(CheckHorizon, FindsAimsThatAllLieAbove) {
    Horizon all;
    for (int i = 0; i < 20; ++i)
        all.add(10, 0, 1.0);
    EXPECT_EQ(idOf(all.judge()), "shadow.wrong");
    EXPECT_FALSE(all.judge(199)) << "of a pool";
    Horizon spared;
    for (int i = 0; i < 20; ++i)
        spared.add(12, 0, 0.6);
    EXPECT_FALSE(spared.judge()) << "twenty rays, of which those below are not cast";
    EXPECT_FALSE(all.add(9, 1, 0.9).judge());
}

}  // namespace
}  // namespace ticker::tasks
