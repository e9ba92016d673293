// Lights that have one channel alone.
#include <grader/tests/tasks/shadows/KnownParts.h>

#include <gtest/gtest.h>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

/// A red and a blue light; the floor faces both.
/// @param toBlue  Rays to the blue one.
std::optional<Finding> judgeChannels(int toBlue) {
    ShadowByHand made;
    made.ask(Purpose::pureColours, {{0.0, 6.0, 0.0}, {3.0, 6.0, 0.0}});
    made.point();
    made.castArc(10, 0);
    made.castArc(toBlue, 1);
    return checkColourChannels(made.logs());
}

TEST(CheckColourChannels, WantsRaysToEveryLightWhateverItsColour) {
    EXPECT_FALSE(judgeChannels(10));
    const auto none = judgeChannels(0);
    ASSERT_EQ(idOf(none), "shadow.too-few-rays");
    EXPECT_NE(none->message.find("get no shadow rays"), std::string::npos) << none->message;
    EXPECT_NE(none->message.find("only one channel of the colour was looked at"),
              std::string::npos);
    const auto few = judgeChannels(9);
    ASSERT_EQ(idOf(few), "shadow.too-few-rays");
    EXPECT_NE(few->message.find("9 shadow rays instead of 10"), std::string::npos);
}

TEST(CheckValues, NamesLightThatIsLostWhereAChannelIsDark) {
    const auto judgeBlue = [](bool lost) {
        ShadowByHand made;
        for (const Purpose purpose : {Purpose::oneLight, Purpose::pureColours}) {
            ShadowQuestion& asked = made.ask(purpose, {{0.0, 16.0, 0.0}});
            if (purpose == Purpose::pureColours)
                asked.question.scene.pointLights = {
                    {{0.0, 16.0, 0.0}, ColourRGB{0.0, 0.0, 0.8}, 4000.0}};
            asked.question.scene.ambientLighting = ColourRGB{0.1};
            asked.question.scene.planes[0].material.colour = {0.8, 0.6, 0.4};
            PointLog& point = made.point({0.3, 0.0, 1.0});
            const Parts parts = partsOf(point, made.last());
            point.colour = lost && purpose == Purpose::pureColours
                               ? parts.ambient
                               : parts.ambient + parts.diffuse + parts.specular;
        }
        return checkValues(made.logs()).finding;
    };
    EXPECT_FALSE(judgeBlue(false));
    const auto finding = judgeBlue(true);
    ASSERT_EQ(idOf(finding), "shadow.wrong");
    EXPECT_NE(finding->message.find("only one channel"), std::string::npos) << finding->message;
}

}  // namespace
}  // namespace ticker::tasks
