// Mistakes that follow a rule with a number, such as a factor; the colours show the number.
#include <grader/tests/tasks/shadows/KnownParts.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;
using ColourOf = std::function<ColourRGB(const Parts&, int open)>;

constexpr double kLightHeight = 16.0;

/// Asks about one light above a coloured floor.
raytracer::SceneDescription& askAboutFloor(ShadowByHand& made) {
    raytracer::SceneDescription& scene =
        made.ask(Purpose::oneLight, {{0.0, kLightHeight, 0.0}}).question.scene;
    scene.ambientLighting = ColourRGB{0.3};
    scene.planes[0].material.colour = {0.8, 0.6, 0.4};
    return scene;
}

/// Id, message and hint of the finding; empty without one.
std::string toldAbout(const ShadowByHand& made) {
    const auto finding = checkArithmetic(made.logs()).finding;
    return finding ? idOf(finding) + ": " + finding->message + " | " + finding->hint : "";
}

/// What is told of points at which so many of ten rays arrive, one point for each of `opens`.
std::string told(const ColourOf& colourOf, const std::vector<int>& opens = {0, 2, 4, 6, 8, 10}) {
    ShadowByHand made;
    askAboutFloor(made);
    for (const int open : opens) {
        PointLog& point = made.point({0.1 * open, 0.0, 1.0});
        made.castArc(10);
        point.zones = {open == 10 ? Zone::lit : open == 0 ? Zone::umbra : Zone::penumbra};
        for (int i = open; i < 10; ++i)
            point.lines[0][static_cast<std::size_t>(i)].toLight = Sight::blocked;
        point.colour = colourOf(partsOf(point, made.last()), open);
    }
    return toldAbout(made);
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

ColourOf withAmbient(double times) {
    return [=](const Parts& p, int open) {
        return p.ambient * times + (p.diffuse + p.specular) * (open / 10.0);
    };
}

TEST(ExplainedShadows, SaysHowManyTimesTheAmbientLightIsThere) {
    EXPECT_EQ(told(withAmbient(1.0)), "");
    EXPECT_TRUE(has(told(withAmbient(0.1)), "the ambient light is 0.1 times"))
        << told(withAmbient(0.1));
    EXPECT_TRUE(has(told(withAmbient(0.1)), "divide"));
    EXPECT_TRUE(has(told(withAmbient(10.0)), "the ambient light is 10 times"));
    EXPECT_TRUE(has(told(withAmbient(10.0)), "not once for each ray"));
    EXPECT_TRUE(has(told(withAmbient(11.0)), "not once for each ray"));
    EXPECT_FALSE(has(told(withAmbient(2.0)), "each ray"));
    EXPECT_FALSE(has(told(withAmbient(0.1), {2, 4, 6, 8, 10}), "the ambient light is"))
        << "no point shows it alone";
    EXPECT_TRUE(has(told(withAmbient(2.0)), "the ambient light is 2 times"));
    EXPECT_TRUE(has(told(withAmbient(0.0)), "the ambient light is missing"));
    EXPECT_FALSE(has(told([](const Parts& p, int open) {
                         return p.ambient * (open > 4 ? 2.0 : 3.0) +
                                (p.diffuse + p.specular) * (open / 10.0);
                     }),
                     "the ambient light is"))
        << "not the same everywhere";
    EXPECT_FALSE(has(told([](const Parts& p, int open) {
                         return p.ambient * 0.1 + (p.diffuse + p.specular) * (open / 5.0);
                     }),
                     "the ambient light is"))
        << "the rest is wrong, too";
}

ColourOf fading(double kept) {
    return [=](const Parts& p, int open) {
        return p.ambient + (p.diffuse + p.specular) * std::pow(kept, 10 - open);
    };
}

TEST(ExplainedShadows, KnowsLightThatEachBlockedRayMultiplies) {
    for (const double kept : {0.9, 0.5, 0.95}) {
        EXPECT_TRUE(has(told(fading(kept)), "each blocked ray multiplies")) << told(fading(kept));
        EXPECT_TRUE(has(told(fading(kept)), "share -= 1.0 / n"));
    }
    EXPECT_TRUE(has(told(fading(0.9)), "by 0.9")) << told(fading(0.9));
    EXPECT_FALSE(has(told(fading(0.9), {0, 10}), "multiplies")) << "any rule fits one number";
    const ColourOf squared = [](const Parts& p, int open) {
        return p.ambient + (p.diffuse + p.specular) * (open * open / 100.0);
    };
    EXPECT_FALSE(has(told(squared), "multiplies"));
}

ColourOf toThePower(double power) {
    return [=](const Parts& p, int open) {
        return p.ambient + (p.diffuse + p.specular) * std::pow(open / 10.0, power);
    };
}

TEST(ExplainedShadows, KnowsAPowerOfTheShare) {
    const std::string squared = told(toThePower(2.0));
    EXPECT_TRUE(has(squared, "the share to the power 2 does")) << squared;
    EXPECT_TRUE(has(squared, "where 4 of 10 arrive, 0.16 of the light")) << squared;
    EXPECT_TRUE(has(told(toThePower(0.5)), "power 0.5 ")) << told(toThePower(0.5));
    EXPECT_FALSE(has(told(toThePower(2.0), {0, 4}), "power")) << "any two points have one";
    EXPECT_FALSE(has(told([](const Parts& p, int open) {
                         const double share = open / 10.0;
                         return p.ambient +
                                (p.diffuse + p.specular) * (share * share * (3.0 - 2.0 * share));
                     }),
                     "power"));
}

/// A point of the floor, in full light or in full shadow, that the code lights or leaves dark.
struct FloorPoint {
    double x;
    bool isInShadow;
    bool comesOutLit;
};

void addPoint(ShadowByHand& made, const FloorPoint& at) {
    PointLog& point = made.point({at.x, 0.0, 0.0});
    point.point.object = static_cast<int>(made.last().scene().spheres.size());
    made.castArc(10, 0, 0.05);
    point.zones = {at.isInShadow ? Zone::umbra : Zone::lit};
    for (AimLine& line : point.lines[0])
        line.toLight = at.isInShadow ? Sight::blocked : Sight::open;
    const Parts parts = partsOf(point, made.last());
    point.colour = parts.ambient;
    if (at.comesOutLit) point.colour += parts.diffuse + parts.specular;
}

/// What is told of points in the shadow of a sphere near the floor, in that of one far above it,
/// and in none.
/// @param nearIsLit, farIsLit    Whether points in these shadows come out lit.
/// @param nearHeight, farHeight  Of the lowest points of the spheres, above the floor.
std::string toldOfSpheres(bool nearIsLit, bool farIsLit, double nearHeight = 1.0,
                          double farHeight = 9.0) {
    constexpr double kNearRadius = 0.4;
    constexpr double kFarRadius = 0.9;
    const Vector3 nearCentre{0.0, nearHeight + kNearRadius, 0.0};
    const Vector3 farCentre{2.0, farHeight + kFarRadius, 0.0};
    ShadowByHand made;
    askAboutFloor(made).spheres = {{nearCentre, kNearRadius, {}, nullptr},
                                   {farCentre, kFarRadius, {}, nullptr}};
    const double nearShadow = 0.0;
    const double farShadow = farCentre.x * kLightHeight / (kLightHeight - farCentre.y);
    for (const FloorPoint& at : {FloorPoint{nearShadow, true, nearIsLit},
                                 {nearShadow, true, nearIsLit},
                                 {farShadow, true, farIsLit},
                                 {farShadow, true, farIsLit},
                                 {-4.0, false, true},
                                 {-5.0, false, true}})
        addPoint(made, at);
    return toldAbout(made);
}

TEST(ExplainedShadows, KnowsASquaredDistanceThatIsComparedWithAPlainOne) {
    EXPECT_EQ(toldOfSpheres(false, false), "");
    const std::string squared = toldOfSpheres(false, true);
    EXPECT_TRUE(has(squared, "something smaller than")) << squared;
    EXPECT_TRUE(has(squared, "both plain or both squared"));
    EXPECT_FALSE(has(toldOfSpheres(true, false), "something smaller than"));
    EXPECT_FALSE(has(toldOfSpheres(true, true), "something smaller than"));
    EXPECT_TRUE(has(toldOfSpheres(false, true, 3.5), "something smaller than"));
    EXPECT_FALSE(has(toldOfSpheres(false, true, 4.8, 11.0), "something smaller than"))
        << "farther than the root of 16";
    EXPECT_TRUE(has(toldOfSpheres(false, true, 0.5, 1.6), "nearer than 1"))
        << toldOfSpheres(false, true, 0.5, 1.6);
}

}  // namespace
}  // namespace ticker::tasks
