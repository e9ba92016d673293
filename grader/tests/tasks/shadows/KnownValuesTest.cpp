// Values that follow from geometry alone, and their findings.
#include <grader/tests/tasks/shadows/KnownParts.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

/// Eight points of each zone in questions of five purposes, each with the colour `colourOf(parts,
/// zone, purpose)`.
template <typename ColourOf>
ArithmeticVerdict judge(const ColourOf& colourOf, bool viewerIsEye = false) {
    ShadowByHand made;
    for (const Purpose purpose : {Purpose::oneLight, Purpose::beyondLight, Purpose::severalLights,
                                  Purpose::planeShadow, Purpose::inLine}) {
        ShadowQuestion& asked = made.ask(purpose, {{0.0, 16.0, 0.0}});
        asked.question.scene.planes[0].material.colour = {0.8, 0.6, 0.4};
        asked.question.scene.ambientLighting = ColourRGB{0.1};
        for (int i = 0; i < 8; ++i)
            for (const Zone zone : {Zone::lit, Zone::umbra, Zone::penumbra}) {
                PointLog& point = made.point({0.3 * i, 0.0, 1.0});
                point.point.viewer = {-0.3 * i, 16.0, -1.0};
                point.zones = {zone};
                point.colour = colourOf(partsOf(point, made.last(), 0, viewerIsEye), zone, purpose);
            }
    }
    return checkValues(made.logs());
}

ColourRGB right(const Parts& parts, Zone zone, Purpose = Purpose::oneLight) {
    if (zone == Zone::penumbra) return {9.0, 9.0, 9.0};  // anything
    return zone == Zone::lit ? parts.ambient + parts.diffuse + parts.specular : parts.ambient;
}

TEST(CheckValues, AcceptsWhatGeometryGives) {
    const ArithmeticVerdict verdict = judge(right);
    EXPECT_FALSE(verdict.finding);
    ASSERT_TRUE(verdict.reading);
    EXPECT_FALSE(verdict.reading->viewerIsEye);
}

TEST(CheckValues, NamesWhatAShadowKeeps) {
    const auto inShadow = [](auto change) {
        return idOf(judge([=](const Parts& parts, Zone zone, Purpose) {
                        return zone == Zone::umbra ? change(parts) : right(parts, zone);
                    }).finding);
    };
    EXPECT_EQ(inShadow([](const Parts&) { return ColourRGB{}; }), "shadow.ambient-scaled");
    EXPECT_EQ(inShadow([](const Parts& p) { return p.ambient + p.specular; }),
              "shadow.specular-unshadowed");
    EXPECT_EQ(inShadow([](const Parts& p) { return p.ambient + p.diffuse; }),
              "shadow.diffuse-unshadowed");
    EXPECT_EQ(inShadow([](const Parts& p) { return p.ambient + p.diffuse + p.specular; }),
              "shadow.wrong");
    EXPECT_EQ(inShadow([](const Parts& p) { return p.ambient + ColourRGB{5.0}; }), "shadow.wrong");
}

TEST(CheckValues, TellsHowMuchLightThereIsWhereItIsTheSameEverywhere) {
    const auto messageOf = [](double lit, double umbra) {
        return judge([=](const Parts& p, Zone zone, Purpose) {
                   return p.ambient + (p.diffuse + p.specular) * (zone == Zone::lit ? lit : umbra);
               })
            .finding->message;
    };
    EXPECT_NE(messageOf(1.5, 0.0).find(": 1.5 of the light"), std::string::npos);
    EXPECT_NE(messageOf(1.5, 0.0).find(", 0 in full shadow"), std::string::npos);
    EXPECT_NE(messageOf(1.0, 0.5).find(", 0.5 in full shadow"), std::string::npos);
    const auto uneven = judge([](const Parts& p, Zone zone, Purpose) {
        return right(p, zone) + ColourRGB{zone == Zone::umbra ? 5.0 : 0.0};
    });
    EXPECT_EQ(uneven.finding->message.find("of the light"), std::string::npos);
}

TEST(CheckValues, TellsInvertedShadowsFromNone) {
    const auto inverted = judge([](const Parts& parts, Zone zone, Purpose) {
        return right(parts, zone == Zone::lit     ? Zone::umbra
                            : zone == Zone::umbra ? Zone::lit
                                                  : zone);
    });
    EXPECT_EQ(idOf(inverted.finding), "shadow.inverted");
    const auto none =
        judge([](const Parts& parts, Zone, Purpose) { return right(parts, Zone::lit); });
    ASSERT_EQ(idOf(none.finding), "shadow.wrong");
    EXPECT_NE(none.finding->message.find("nothing ever casts"), std::string::npos);
}

TEST(CheckValues, TellsWhichQuestionIsWrongAlone) {
    const auto wrongIn = [](Purpose wrong) {
        return idOf(judge([=](const Parts& parts, Zone zone, Purpose purpose) {
                        return purpose == wrong ? ColourRGB{7.0} : right(parts, zone);
                    }).finding);
    };
    EXPECT_EQ(wrongIn(Purpose::beyondLight), "shadow.beyond-light");
    EXPECT_EQ(wrongIn(Purpose::severalLights), "shadow.lights-mixed");
    EXPECT_EQ(wrongIn(Purpose::planeShadow), "shadow.wrong");
}

TEST(CheckValues, SaysThatAmbientLightIsThereForEachOfThreeLights) {
    const auto withAmbient = [](double times) {
        ShadowByHand made;
        for (const Purpose purpose : {Purpose::oneLight, Purpose::severalLights}) {
            const std::size_t lights = purpose == Purpose::oneLight ? 1 : 3;
            ShadowQuestion& asked =
                made.ask(purpose, std::vector<Vector3>(lights, Vector3{0.0, 16.0, 0.0}));
            asked.question.scene.planes[0].material.colour = {0.8, 0.6, 0.4};
            asked.question.scene.ambientLighting = ColourRGB{0.5};
            PointLog& point = made.point();
            const Parts parts = partsOf(point, made.last());
            point.colour = parts.ambient * (lights == 1 ? 1.0 : times) +
                           (parts.diffuse + parts.specular) * static_cast<double>(lights);
        }
        return checkValues(made.logs()).finding;
    };
    EXPECT_FALSE(withAmbient(1.0));
    ASSERT_EQ(idOf(withAmbient(3.0)), "shadow.lights-mixed");
    EXPECT_NE(withAmbient(3.0)->message.find("once for each light"), std::string::npos);
    EXPECT_NE(withAmbient(3.0)->hint.find("add it once, before the loop"), std::string::npos);
    ASSERT_EQ(idOf(withAmbient(-1.0)), "shadow.lights-mixed");
    EXPECT_EQ(withAmbient(-1.0)->message.find("once for each light"), std::string::npos);
}

TEST(CheckValues, SaysThatObjectsInLineAreMistaken) {
    const auto lit = judge([](const Parts& parts, Zone zone, Purpose purpose) {
        return right(parts, purpose == Purpose::inLine ? Zone::lit : zone);
    });
    ASSERT_EQ(idOf(lit.finding), "shadow.wrong");
    EXPECT_NE(lit.finding->message.find("one behind the other"), std::string::npos);
    EXPECT_NE(lit.finding->hint.find("the nearest hit"), std::string::npos);
}

TEST(CheckValues, SaysThatPlanesCastNoShadow) {
    const auto lit = judge([](const Parts& parts, Zone zone, Purpose purpose) {
        return right(parts, purpose == Purpose::planeShadow ? Zone::lit : zone);
    });
    ASSERT_EQ(idOf(lit.finding), "shadow.wrong");
    EXPECT_NE(lit.finding->message.find("a plane between"), std::string::npos);
    EXPECT_NE(lit.finding->hint.find("planes as well"), std::string::npos);
}

TEST(CheckValues, TellsTheHighlightFromTheDiffuseLight) {
    const auto large = judge([](const Parts& parts, Zone zone, Purpose) {
        return right(parts, zone) + (zone == Zone::lit ? parts.specular * 40.0 : ColourRGB{});
    });
    ASSERT_EQ(idOf(large.finding), "shadow.wrong");
    EXPECT_NE(large.finding->message.find("the highlight"), std::string::npos);
    EXPECT_NE(large.finding->hint.find("unit length"), std::string::npos);
    const auto diffuse = judge([](const Parts& parts, Zone zone, Purpose) {
        return right(parts, zone) + (zone == Zone::lit ? parts.diffuse : ColourRGB{});
    });
    EXPECT_EQ(diffuse.finding->message.find("the highlight"), std::string::npos);
}

// A larger light, or corners of a cube, meet objects beside the light as well.
TEST(CheckValues, LeavesOpenWhatTakesAPartOfTheLightAway) {
    const auto keeps = [](double share) {
        return judge([=](const Parts& p, Zone zone, Purpose purpose) {
                   const bool dim = purpose == Purpose::beyondLight && zone == Zone::lit;
                   return dim ? p.ambient + (p.diffuse + p.specular) * share
                              : right({p.ambient, p.diffuse, p.specular}, zone);
               })
            .finding;
    };
    ASSERT_EQ(idOf(keeps(0.0)), "shadow.beyond-light");
    EXPECT_EQ(keeps(0.0)->hint.find("lightSize"), std::string::npos);
    ASSERT_EQ(idOf(keeps(0.7)), "shadow.beyond-light");
    EXPECT_NE(keeps(0.7)->hint.find("lightSize"), std::string::npos);
}

TEST(IsNearKnown, AllowsTheLightsAngularSize) {
    for (const double height : {8.0, 2.0}) {
        ShadowByHand made;
        ShadowQuestion& asked = made.ask(Purpose::oneLight, {{0.0, height, 0.0}, {0.0, 30.0, 0.0}});
        raytracer::Material& floor = asked.question.scene.planes[0].material;
        floor.colour = ColourRGB{1.0};
        floor.phongKD = 1.0;
        floor.phongKS = 0.0;
        PointLog& point = made.point();
        point.zones = {Zone::lit, Zone::umbra};
        const ColourRGB expected = ambientPart(point, made.last().scene()) +
                                   unshadowed(point, made.last().scene(), 0, false);
        const ColourRGB full = inFullLight(point, made.last().scene());
        EXPECT_NEAR(full.g, expected.g + unshadowed(point, made.last().scene(), 1, false).g, 1e-9);
        const double share = 0.05 + 2.0 * 0.4 / height;
        for (const double side : {-1.0, 1.0}) {
            point.colour = expected + full * (0.99 * side * share);
            EXPECT_TRUE(isNearKnown(point, made.last(), false));
            point.colour = expected + full * (1.5 * side * share);
            EXPECT_FALSE(isNearKnown(point, made.last(), false));
        }
        point.zones = {Zone::lit, Zone::penumbra};
        EXPECT_TRUE(isNearKnown(point, made.last(), false)) << "nothing is known";
    }
}

// Beside a narrow highlight the terms of single aims lie far from the centre's.
TEST(IsNearKnown, AllowsWhatSingleAimsGiveBesideAHighlight) {
    ShadowByHand made;
    made.ask(Purpose::oneLight, {{0.0, 8.0, 0.0}});
    PointLog& point = made.point();
    point.zones = {Zone::lit};
    const raytracer::SceneDescription& scene = made.last().scene();
    const raytracer::PointLight& light = scene.pointLights[0];
    const Vector3& at = point.point.position;
    const Vector3 edge{0.4, 8.0, 0.0};
    point.point.viewer = at + (edge - at).reflectIn(point.point.normal) * 3.0;
    const auto seen = [&](const Vector3& aim, double distance) {
        return ambientPart(point, scene) +
               phongTerms(materialOf(scene, point.point.object), light, point.point.normal,
                          (point.point.viewer - at).normalised(), (aim - at).normalised(), distance)
                   .sum();
    };
    const double nearest = (light.position() - at).magnitude() - 0.4;
    point.colour = seen(edge, nearest);
    EXPECT_TRUE(isNearKnown(point, made.last(), false));
    point.colour = seen(edge, 0.8 * nearest);
    EXPECT_FALSE(isNearKnown(point, made.last(), false));
}

TEST(Near, HoldsInEveryChannel) {
    const ColourRGB middle{0.5, 0.5, 0.5};
    const ColourRGB slack{0.1, 0.2, 0.3};
    for (const double side : {-1.0, 1.0}) {
        EXPECT_TRUE(near(middle + slack * (0.99 * side), middle, slack));
        EXPECT_FALSE(near(middle + ColourRGB{0.11, 0.0, 0.0} * side, middle, slack));
        EXPECT_FALSE(near(middle + ColourRGB{0.0, 0.21, 0.0} * side, middle, slack));
        EXPECT_FALSE(near(middle + ColourRGB{0.0, 0.0, 0.31} * side, middle, slack));
    }
}

}  // namespace
}  // namespace ticker::tasks
