// The colours of the points tell the highlight from the diffuse light: bounds of what counts as
// right.
#include <grader/tasks/shadows/checks/HighlightCheck.h>
#include <grader/tests/tasks/shadows/KnownParts.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace ticker::tasks {
namespace {

/// Changes a point, whose right parts of the light are given.
using Repaint = std::function<void(PointLog& point, const Parts& parts, int number)>;

std::optional<Finding> highlightOf(const Repaint& repaint, int points = 8) {
    ShadowByHand made;
    ShadowQuestion& asked = made.ask(ShadowQuestion::Purpose::oneLight, {{0.0, 16.0, 0.0}});
    asked.question.scene.planes[0].material.colour = {0.8, 0.6, 0.4};
    asked.question.scene.ambientLighting = ColourRGB{0.1};
    for (int i = 0; i < points; ++i) {
        PointLog& point = made.point({0.1 * i, 0.0, 1.0});
        point.point.viewer = {-0.1 * i, 6.0, -1.0};
        const Parts parts = partsOf(point, made.last());
        point.colour = parts.ambient + parts.diffuse + parts.specular * 1.5;
        repaint(point, parts, i);
    }
    return highlightAlone(made.logs().oneLight);
}

void asItIs(PointLog&, const Parts&, int) {}

Repaint scaled(double diffuse, double specular) {
    return [=](PointLog& point, const Parts& parts, int) {
        point.colour = parts.ambient + parts.diffuse * diffuse + parts.specular * specular;
    };
}

// The light stands at 68 degrees from the normal, and the viewers at 74 on its side: R.V is -0.79.
std::optional<Finding> highlightOfLowLightWith(double specular) {
    ShadowByHand made;
    ShadowQuestion& asked = made.ask(ShadowQuestion::Purpose::lowLight, {{15.0, 6.0, 0.0}});
    asked.question.scene.planes[0].material.colour = {0.8, 0.6, 0.4};
    asked.question.scene.planes[0].material.phongAlpha = 2.0;
    for (int i = 0; i < 10; ++i) {
        PointLog& point = made.point({0.05 * i, 0.0, 0.0});
        point.point.viewer = {3.5, 1.0, 0.0};
        const Parts parts = partsOf(point, made.last());
        EXPECT_DOUBLE_EQ(parts.specular.r, 0.0);
        point.colour = parts.ambient + parts.diffuse + ColourRGB{specular};
    }
    return highlightOfLowLight(made.logs().lowLight);
}

TEST(HighlightOfLowLight, IsNamedWhereTheViewerSeesOneFromTheWrongSide) {
    EXPECT_FALSE(highlightOfLowLightWith(0.0));
    for (const double specular : {0.5, -0.5}) {  // of an even and of an odd power
        const std::optional<Finding> finding = highlightOfLowLightWith(specular);
        ASSERT_TRUE(finding);
        EXPECT_NE(finding->hint.find("std::max(0.0, R.dot(V))"), std::string::npos);
    }
}

TEST(HighlightAlone, NeedsEightPointsWhoseShareOfLightIsKnown) {
    EXPECT_TRUE(highlightOf(asItIs, 8));
    EXPECT_FALSE(highlightOf(asItIs, 7));
    EXPECT_FALSE(highlightOf([](PointLog& point, const Parts&, int number) {
        if (number == 3) point.zones = {Zone::penumbra};
    }));
    EXPECT_FALSE(highlightOf([](PointLog& point, const Parts&, int number) {
        point.lines[0].resize(2);
        for (AimLine& line : point.lines[0])
            line.toLight = Sight::open;
        if (number == 3) point.lines[0][0].toLight = Sight::unsure;
    }));
}

TEST(HighlightAlone, CountsTheRaysThatArrive) {
    const auto halfOpen = [](double share) {
        return [=](PointLog& point, const Parts& parts, int) {
            point.lines[0].resize(4);
            for (std::size_t i = 0; i < 4; ++i)
                point.lines[0][i].toLight = i < 2 ? Sight::open : Sight::blocked;
            point.colour = parts.ambient + parts.diffuse * share + parts.specular;
        };
    };
    EXPECT_TRUE(highlightOf(halfOpen(0.5)));
    EXPECT_FALSE(highlightOf(halfOpen(1.0)));
}

TEST(HighlightAlone, AllowsAHundredthOfTheDiffuseLightAndOfTheHighlight) {
    EXPECT_TRUE(highlightOf(scaled(1.009, 1.5)));
    EXPECT_TRUE(highlightOf(scaled(0.991, 1.5)));
    EXPECT_FALSE(highlightOf(scaled(1.02, 1.5)));
    EXPECT_FALSE(highlightOf(scaled(0.98, 1.5)));
    EXPECT_FALSE(highlightOf(scaled(1.0, 1.005)));
    EXPECT_TRUE(highlightOf(scaled(1.0, 1.05)));
    EXPECT_TRUE(highlightOf(scaled(1.0, 0.9)));
}

// This happens where code uses the way to the light instead of its direction and raises the product
// to a high power.
TEST(HighlightAlone, MayBeSoLargeThatRoundingTakesTheDiffuseLight) {
    for (const double times : {1e13, 1e14, 1e15, 1e16})
        EXPECT_TRUE(highlightOf(scaled(1.0, times))) << times;
}

TEST(HighlightAlone, SaysNothingOfColoursThatNoTwoPartsExplain) {
    const auto tinted = [](double share) {
        return [=](PointLog& point, const Parts& parts, int) {
            const ColourRGB diffuse = parts.diffuse;
            point.colour +=
                ColourRGB{diffuse.g - diffuse.b, diffuse.b - diffuse.r, diffuse.r - diffuse.g} *
                share;
        };
    };
    EXPECT_TRUE(highlightOf(tinted(1e-4)));
    EXPECT_FALSE(highlightOf(tinted(0.02)));
}

TEST(HighlightAlone, ShowsThePointThatIsFarthestOff) {
    const auto finding = highlightOf([](PointLog& point, const Parts& parts, int number) {
        point.colour = parts.ambient + parts.diffuse + parts.specular * (number == 4 ? 2.0 : 1.2);
    });
    ASSERT_TRUE(finding);
    EXPECT_NEAR(numberIn(*finding, "highlightSeen") / numberIn(*finding, "highlightExpected"), 2.0,
                1e-6);
}

TEST(HighlightAlone, KnowsDirectionsThatAreNoUnitVectors) {
    const Vector3 light{0.0, 16.0, 0.0};
    const auto hintOf = [](const std::function<double(const probe::LitPoint&)>& stretch) {
        const auto finding = highlightOf([&](PointLog& point, const Parts& parts, int) {
            const double alpha = raytracer::Material{}.phongAlpha;
            point.colour = parts.ambient + parts.diffuse +
                           parts.specular * std::pow(stretch(point.point), alpha);
        });
        return finding ? finding->hint : std::string{};
    };
    const auto toLight = hintOf([&](const auto& at) { return (light - at.position).magnitude(); });
    EXPECT_NE(toLight.find("unit vector to the light"), std::string::npos);
    const auto toViewer =
        hintOf([](const auto& at) { return (at.viewer - at.position).magnitude(); });
    EXPECT_NE(toViewer.find("direction to the viewer has unit length"), std::string::npos);
    EXPECT_NE(hintOf([](const auto&) { return 3.0; }).find("Both directions"), std::string::npos);
}

TEST(HighlightAlone, SaysHowManyTimesTooStrongItIsEverywhere) {
    const auto toldOf = [](double times) {
        const auto finding = highlightOf(scaled(1.0, times));
        return finding ? finding->message + finding->hint : std::string{};
    };
    EXPECT_NE(toldOf(10.0).find("10 times"), std::string::npos) << toldOf(10.0);
    EXPECT_NE(toldOf(10.0).find("(diffuse + specular) / n"), std::string::npos);
    EXPECT_NE(toldOf(0.1).find("0.1 times"), std::string::npos);
    EXPECT_NE(toldOf(0.1).find("divided once"), std::string::npos);
    EXPECT_NE(toldOf(2.0).find("2 times"), std::string::npos);
    EXPECT_EQ(toldOf(2.0).find("/ n"), std::string::npos);
    EXPECT_NE(toldOf(0.0).find("missing"), std::string::npos);
    const auto uneven = highlightOf([](PointLog& point, const Parts& parts, int number) {
        point.colour = parts.ambient + parts.diffuse + parts.specular * (number == 4 ? 9.0 : 10.0);
    });
    EXPECT_EQ(uneven->message.find("times"), std::string::npos);
}

}  // namespace
}  // namespace ticker::tasks
