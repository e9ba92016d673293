// An odd number of rays.
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

/// A question that asks for 7 rays; its point gets `rays`.
std::optional<Finding> judgeOdd(int rays, double colourTimes = 1.0) {
    ShadowByHand made;
    made.ask(Purpose::oddCount, {{0.0, 20.0, 0.0}}).question.settings.shadowRayCount = 7;
    PointLog& point = made.point();
    made.castArc(rays);
    const raytracer::SceneDescription& scene = made.last().scene();
    point.colour = (ambientPart(point, scene) + unshadowed(point, scene, 0, false)) * colourTimes;
    return checkOddCount(made.logs());
}

TEST(CheckOddCount, WantsAsManyRaysOrMore) {
    EXPECT_FALSE(judgeOdd(7));
    EXPECT_FALSE(judgeOdd(8));
    EXPECT_FALSE(judgeOdd(9));
    const auto lost = judgeOdd(6);
    ASSERT_EQ(idOf(lost), "shadow.too-few-rays");
    EXPECT_NE(lost->message.find("With 10 shadow rays all is right; asked for 7"),
              std::string::npos)
        << lost->message;
    EXPECT_EQ(numberIn(*lost, "raysSeen"), 6.0);
}

TEST(CheckOddCount, WantsTheLightDividedByTheirNumber) {
    EXPECT_EQ(idOf(judgeOdd(8, 8.0 / 7.0)), "shadow.wrong");
    EXPECT_FALSE(judgeOdd(10, 10.0 / 7.0)) << "the handout's number, typed in";
    EXPECT_FALSE(judgeOdd(7, 7.0 / 10.0)) << "divided by the handout's number";
    const auto cut = judgeOdd(7, 6.0 / 7.0);
    ASSERT_EQ(idOf(cut), "shadow.wrong");
    EXPECT_NE(cut->message.find("not the share of them"), std::string::npos) << cut->message;
}

}  // namespace
}  // namespace ticker::tasks
