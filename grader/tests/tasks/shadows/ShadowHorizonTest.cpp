#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::tasks {
namespace {

/// Points with a light 0.1 above their floor, or so high, seen along the mirrored direction.
class Horizon {
public:
    explicit Horizon(double height = 0.1) {
        made_.ask(ShadowQuestion::Purpose::horizon, {{4.0, height, 0.0}});
    }

    /// A point with this many rays above and below the horizon, and this share of the light.
    Horizon& add(int above, int below, double share) {
        PointLog& point = made_.point();
        point.point.viewer = {-4.0, 0.1, 0.0};
        for (int i = 0; i < above; ++i)
            made_.cast({4.0, 0.11 + 0.01 * i, 0.0});
        for (int i = 0; i < below; ++i)
            made_.cast({4.0, -0.11 - 0.01 * i, 0.0}).toLight = Sight::blocked;
        return light(share);
    }
    /// Likewise, but rays start on the floor. Those that meet it there are cast again from above
    /// it: it is unsure what each ray does. Where none does, those below the horizon arrive.
    Horizon& addFromFloor(int above, int below, bool meetsFloor) {
        const double share = above / (1.0 * above + below);
        add(above, meetsFloor ? 2 * below : below, meetsFloor ? share : 1.0);
        for (AimLine& line : made_.last().points.back().lines[0])
            if (meetsFloor || line.toLight == Sight::blocked) line.toLight = Sight::unsure;
        return *this;
    }
    /// Likewise, but a ball blocks some of the rays above the horizon.
    Horizon& addBehindBall(int open, int hidden, int below, double share) {
        add(open, below, 0.0);
        for (int i = 0; i < hidden; ++i)
            made_.cast({4.0, 0.31 + 0.01 * i, 0.0}).toLight = Sight::blocked;
        return light(share);
    }
    /// Likewise, but the other rays go to aims on the horizon, in the plane of the floor: `before`
    /// of them are blocked by the floor, `behind` of them arrive.
    Horizon& addLevel(int above, int before, int behind, double share) {
        add(above, 0, 0.0);
        for (int i = 0; i < before; ++i)
            made_.cast({3.9, 0.0, 0.01 * i}).toLight = Sight::blocked;
        for (int i = 0; i < behind; ++i)
            made_.cast({4.1, 0.0, 0.01 * i});
        return light(share);
    }
    /// The last point has this share of the light.
    Horizon& light(double share) {
        PointLog& point = made_.last().points.back();
        point.colour = ambientPart(point, made_.last().scene()) +
                       unshadowed(point, made_.last().scene(), 0, false) * share;
        return *this;
    }
    /// The last point is darker by this than it was.
    Horizon& darken(double difference) {
        ColourRGB& colour = made_.last().points.back().colour;
        colour = colour - ColourRGB{difference};
        return *this;
    }
    [[nodiscard]] std::optional<Finding> judge(std::size_t distinct = 2000,
                                               const ShadowReading& reading = {}) const {
        AimVerdict aims;
        aims.lines = 2010;
        aims.distinct = distinct;
        return checkHorizon(made_.logs(), aims, reading);
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

TEST(CheckHorizon, FindsAShareOfTheRaysAboveThoughAllAreCast) {
    const auto left =
        Horizon{}.addBehindBall(2, 4, 4, 2.0 / 6.0).addBehindBall(3, 4, 3, 3.0 / 7.0).judge();
    ASSERT_EQ(idOf(left), "shadow.wrong");
    EXPECT_NE(left->message.find("6 of 10 rays are above it and 2 arrive, there is 2/6"),
              std::string::npos)
        << left->message;
    EXPECT_FALSE(Horizon{}.addBehindBall(2, 4, 4, 0.2).addBehindBall(3, 4, 3, 0.3).judge());
    EXPECT_FALSE(Horizon{}.addBehindBall(2, 4, 4, 0.6).addBehindBall(3, 4, 3, 0.6).judge())
        << "hits on the floor that they leave are ignored";
    EXPECT_FALSE(Horizon{}.add(6, 4, 1.0).add(7, 3, 1.0).judge()) << "likewise, without a ball";
}

// Rays that start on the floor itself hit it there or do not, as rounding of the point decides.
TEST(CheckHorizon, SaysNothingAboutRaysWhoseFloorRoundingDecides) {
    Horizon fromFloor;
    for (int i = 0; i < 20; ++i)
        fromFloor.addFromFloor(4, 6, i % 2 == 0);
    EXPECT_FALSE(fromFloor.judge());
}

TEST(CheckHorizon, FindsALightThatTakesAway) {
    EXPECT_FALSE(Horizon{-0.1}.add(2, 8, 0.0).judge());
    const auto darker = Horizon{-0.1}.add(2, 8, 0.0).darken(0.01).judge();
    ASSERT_EQ(idOf(darker), "shadow.wrong");
    EXPECT_NE(darker->hint.find("max(0.0, N.dot(L))"), std::string::npos) << darker->hint;
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

// In one of a hundred draws of the question an aim is this near to the horizon.
TEST(CheckHorizon, LetsNoAimNextToTheHorizonHideWhatTheOthersShow) {
    Horizon mirrored;
    for (int i = 0; i < 20; ++i)
        mirrored.addLevel(10, 0, 0, 1.0);
    EXPECT_EQ(idOf(mirrored.addLevel(9, 1, 0, 1.0).judge()), "shadow.wrong");
    const auto left = Horizon{}.add(8, 0, 1.0).addLevel(6, 1, 0, 1.0).judge();
    ASSERT_EQ(idOf(left), "shadow.wrong");
    EXPECT_NE(left->message.find("there is 7/7 of the light"), std::string::npos) << left->message;
    EXPECT_FALSE(Horizon{}.addLevel(6, 1, 0, 0.7).addLevel(6, 1, 0, 0.6).judge()) << "spared";
}

// An aim a little below the horizon arrives where the ray starts a little above the surface. Code
// that leaves it out of the divisor alone gives that point more light than any share of its rays.
TEST(CheckHorizon, LetsNoAimThatIsLeftOutOfTheDivisorAloneHideWhatTheOthersShow) {
    Horizon left;
    left.addBehindBall(2, 4, 4, 2.0 / 6.0).addLevel(6, 0, 1, 7.0 / 6.0);
    EXPECT_EQ(idOf(left.judge()), "shadow.wrong");
    Horizon levelFirst;
    levelFirst.addLevel(6, 0, 1, 7.0 / 6.0).addBehindBall(2, 4, 4, 2.0 / 6.0);
    EXPECT_EQ(idOf(levelFirst.judge()), "shadow.wrong");
    EXPECT_FALSE(Horizon{}.addLevel(6, 0, 1, 7.0 / 6.0).judge()) << "no other point";
    EXPECT_FALSE(Horizon{}.addBehindBall(2, 4, 4, 0.2).addLevel(6, 0, 1, 0.7).judge())
        << "every ray counts";
}

// The floor is as far as the aim, so that rounding decides which of these rays arrive.
TEST(CheckHorizon, FindsAimsThatAreMovedOntoTheHorizon) {
    Horizon moved;
    Horizon open;
    Horizon blocked;
    for (int i = 0; i < 20; ++i) {
        moved.addLevel(6, 2, 2, i % 2 == 0 ? 0.8 : 0.9);
        open.addLevel(6, 2, 2, 1.0);
        blocked.addLevel(6, 2, 2, 0.6);
    }
    EXPECT_EQ(idOf(moved.judge()), "shadow.wrong");
    EXPECT_EQ(idOf(open.judge()), "shadow.wrong");
    EXPECT_FALSE(blocked.judge()) << "the share is right";
}

TEST(CheckHorizon, FindsAimsThatAllLieAboveForEachTermOfItsOwn) {
    const ShadowReading apart{.terms = ShadowReading::Terms::halves};
    Horizon all;
    for (int i = 0; i < 20; ++i)
        all.add(20, 0, 1.0);
    EXPECT_EQ(idOf(all.judge(2000, apart)), "shadow.wrong");
    Horizon spared;
    for (int i = 0; i < 20; ++i)
        spared.add(13, 0, 0.65);
    EXPECT_FALSE(spared.judge(2000, apart)) << "those below are not cast";
}

}  // namespace
}  // namespace ticker::tasks
