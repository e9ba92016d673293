#include <grader/tests/tasks/shadows/KnownParts.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

/// Points of one light with open and blocked rays, each with a colour that `colourOf` computes from
/// the open share.
template <typename ColourOf>
std::optional<Finding> judgeRays(const ColourOf& colourOf,
                                 const std::vector<int>& opens = {0, 2, 4, 6, 8, 10}) {
    ShadowByHand made;
    made.ask(Purpose::oneLight, {{0.0, 16.0, 0.0}});
    for (const int open : opens) {
        PointLog& point = made.point({0.1 * open, 0.0, 1.0});
        made.castArc(10);
        point.zones = {open == 10 ? Zone::lit : open == 0 ? Zone::umbra : Zone::penumbra};
        for (int i = open; i < 10; ++i)
            point.lines[0][static_cast<std::size_t>(i)].toLight = Sight::blocked;
        point.colour = colourOf(partsOf(point, made.last()), open);
    }
    return checkArithmetic(made.logs()).finding;
}

TEST(CheckArithmetic, AcceptsTheShareThatArrives) {
    EXPECT_EQ(idOf(judgeRays([](const Parts& p, int open) {
                  return p.ambient + (p.diffuse + p.specular) * (open / 10.0);
              })),
              "");
}

TEST(CheckArithmetic, TellsAllOrNothingOfWhateverRule) {
    const auto odd = judgeRays([](const Parts& p, int open) {
        const bool isLit = open == 10 || open == 4;
        return p.ambient + (p.diffuse + p.specular) * (isLit ? 1.0 : 0.0);
    });
    ASSERT_EQ(idOf(odd), "shadow.all-or-nothing");
    EXPECT_NE(odd->message.find("never a part"), std::string::npos);
    const auto few = judgeRays(
        [](const Parts& p, int open) {
            const bool isLit = open == 10 || open == 4;
            return p.ambient + (p.diffuse + p.specular) * (isLit ? 1.0 : 0.0);
        },
        {0, 0, 2, 4, 6, 10, 10});
    EXPECT_EQ(idOf(few), "shadow.wrong") << "three points at the edge say nothing";
    const auto unlit = judgeRays([](const Parts& p, int open) {
        return p.ambient + (p.diffuse + p.specular) * (open == 4 ? 1.0 : 0.0);
    });
    EXPECT_EQ(idOf(unlit), "shadow.wrong") << "dark in plain light";
    const auto lit = judgeRays([](const Parts& p, int open) {
        return p.ambient + (p.diffuse + p.specular) * (open % 4 == 0 ? 1.0 : 0.0);
    });
    EXPECT_EQ(idOf(lit), "shadow.wrong") << "lit in full shadow";
}

TEST(CheckArithmetic, SaysWhatToDivideByWhereOneRayIsEnough) {
    const auto any = judgeRays([](const Parts& p, int open) {
        return p.ambient + (p.diffuse + p.specular) * (open > 0 ? 1.0 : 0.0);
    });
    ASSERT_EQ(idOf(any), "shadow.all-or-nothing");
    EXPECT_NE(any->message.find("as soon as one ray arrives"), std::string::npos);
    EXPECT_NE(any->hint.find("the blocked ones as well"), std::string::npos);
}

TEST(CheckArithmetic, NamesTheMeanOverTheRaysThatArrive) {
    const auto mean = [](double perRay) {
        ShadowByHand made;
        made.ask(Purpose::oneLight, {{0.0, 6.0, 0.0}});
        for (const int open : {0, 1, 3, 4, 7, 9, 10}) {
            PointLog& point = made.point({0.1 * open, 0.0, 1.0});
            point.zones = {Zone::penumbra};
            for (int i = 0; i < 10; ++i)
                made.cast({0.4 * std::cos(i), 6.0, 0.4 * std::sin(i)}).toLight =
                    i < open ? Sight::open : Sight::blocked;
            point.colour = ambientPart(point, made.last().scene());
            for (int i = 0; i < open; ++i) {
                const raytracer::PointLight& light = made.last().scene().pointLights[0];
                const auto terms =
                    phongTerms(made.last().scene().planes[0].material, light, point.point.normal,
                               (point.point.viewer - point.point.position).normalised(),
                               point.lines[0][static_cast<std::size_t>(i)].direction,
                               (light.position() - point.point.position).magnitude());
                point.colour +=
                    (terms.diffuse + terms.specular) * (perRay > 0.0 ? perRay : 1.0 / open);
            }
        }
        return checkArithmetic(made.logs()).finding;
    };
    EXPECT_FALSE(mean(0.1));
    const auto overArrived = mean(0.0);
    ASSERT_EQ(idOf(overArrived), "shadow.all-or-nothing");
    EXPECT_NE(overArrived->message.find("divided by the number of rays that arrive"),
              std::string::npos);
    EXPECT_NE(overArrived->hint.find("blocked ones as well"), std::string::npos);
    EXPECT_NE(idOf(mean(0.2)), "shadow.all-or-nothing");
}

TEST(CheckArithmetic, TellsAShadowOfWhatIsBehindTheLightFromLessLight) {
    const auto behind = [](Sight endlessly, double share) {
        ShadowByHand made;
        for (const Purpose purpose : {Purpose::oneLight, Purpose::beyondLight}) {
            const bool isBehind = purpose == Purpose::beyondLight;
            made.ask(purpose, {{0.0, 16.0, 0.0}});
            PointLog& point = made.point({0.1, 0.0, 1.0});
            made.castArc(10);
            if (isBehind)
                for (AimLine& line : point.lines[0])
                    line.endlessly = endlessly;
            const Parts parts = partsOf(point, made.last());
            point.colour =
                parts.ambient + (parts.diffuse + parts.specular) * (isBehind ? share : 1.0);
        }
        return checkArithmetic(made.logs()).finding;
    };
    EXPECT_EQ(idOf(behind(Sight::blocked, 1.0)), "");
    const auto blocked = behind(Sight::blocked, 0.0);
    ASSERT_EQ(idOf(blocked), "shadow.beyond-light");
    EXPECT_NE(blocked->message.find("casts a shadow on it"), std::string::npos);
    const auto darker = behind(Sight::blocked, 0.4);
    ASSERT_EQ(idOf(darker), "shadow.beyond-light");
    EXPECT_NE(darker->message.find("makes it darker"), std::string::npos);
    EXPECT_NE(darker->hint.find("how far away the light is"), std::string::npos);
}

TEST(CheckArithmetic, ShowsAPointThatDoesNotFit) {
    const auto wrong = judgeRays([](const Parts& p, int open) {
        return p.ambient + p.diffuse * (open / 10.0) + p.specular * (open == 6 ? 0.1 : open / 10.0);
    });
    ASSERT_EQ(idOf(wrong), "shadow.wrong");
    EXPECT_EQ(numberIn(*wrong, "raysThatArrive"), 6.0);
    EXPECT_EQ(numberIn(*wrong, "raysCast"), 10.0);
}

TEST(CheckArithmetic, SeesRaysThatNeverGetOffTheSurface) {
    ShadowByHand made;
    made.ask(Purpose::oneLight, {{0.0, 16.0, 0.0}});
    PointLog& point = made.point({1.0, 0.0, 1.0});
    made.castArc(10);
    point.zones = {Zone::lit};
    for (AimLine& line : point.lines[0])
        line.toLight = Sight::unsure;
    const Parts parts = partsOf(point, made.last());
    point.colour = parts.ambient + (parts.diffuse + parts.specular) * 0.4;
    const ArithmeticVerdict verdict = checkArithmetic(made.logs());
    ASSERT_EQ(idOf(verdict.finding), "shadow.wrong");
    EXPECT_NE(verdict.finding->hint.find("kShadowBias"), std::string::npos);
    point.colour = parts.ambient + parts.diffuse + parts.specular;
    EXPECT_FALSE(checkArithmetic(made.logs()).finding) << "sorted out by the code itself";
}

}  // namespace
}  // namespace ticker::tasks
