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

/// Id, message and hint for points at which so many of ten rays arrive, one point for each of
/// `opens`. Empty without a finding.
std::string told(const ColourOf& colourOf, const std::vector<int>& opens = {0, 2, 4, 6, 8, 10}) {
    ShadowByHand made;
    raytracer::SceneDescription& scene =
        made.ask(Purpose::oneLight, {{0.0, 16.0, 0.0}}).question.scene;
    scene.ambientLighting = ColourRGB{0.3};
    scene.planes[0].material.colour = {0.8, 0.6, 0.4};
    for (const int open : opens) {
        PointLog& point = made.point({0.1 * open, 0.0, 1.0});
        made.castArc(10);
        point.zones = {open == 10 ? Zone::lit : open == 0 ? Zone::umbra : Zone::penumbra};
        for (int i = open; i < 10; ++i)
            point.lines[0][static_cast<std::size_t>(i)].toLight = Sight::blocked;
        point.colour = colourOf(partsOf(point, made.last()), open);
    }
    const auto finding = checkArithmetic(made.logs()).finding;
    return finding ? idOf(finding) + ": " + finding->message + " | " + finding->hint : "";
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

/// Id, message and hint for a light at height 16 and points under a near sphere, under a far sphere
/// and under none. `nearIsLit` and `farIsLit` tell whether the shadowed points are lit.
std::string toldOfSpheres(bool nearIsLit, bool farIsLit, double nearHeight = 1.0,
                          double farHeight = 9.0) {
    ShadowByHand made;
    raytracer::SceneDescription& scene =
        made.ask(Purpose::oneLight, {{0.0, 16.0, 0.0}}).question.scene;
    scene.ambientLighting = ColourRGB{0.3};
    scene.planes[0].material.colour = {0.8, 0.6, 0.4};
    scene.spheres.push_back({{0.0, nearHeight + 0.4, 0.0}, 0.4, {}, nullptr});
    scene.spheres.push_back({{2.0, farHeight + 0.9, 0.0}, 0.9, {}, nullptr});
    const double under = 2.0 * 16.0 / (15.1 - farHeight);
    for (const double x : {0.0, 0.0, under, under, -4.0, -5.0}) {
        PointLog& point = made.point({x, 0.0, 0.0});
        point.point.object = 2;
        made.castArc(10, 0, 0.05);
        const bool isLit = x < 0.0 || (x == 0.0 ? nearIsLit : farIsLit);
        point.zones = {x < 0.0 ? Zone::lit : Zone::umbra};
        for (AimLine& line : point.lines[0])
            line.toLight = x < 0.0 ? Sight::open : Sight::blocked;
        const Parts parts = partsOf(point, made.last());
        point.colour = parts.ambient;
        if (isLit) point.colour += parts.diffuse + parts.specular;
    }
    const auto finding = checkArithmetic(made.logs()).finding;
    return finding ? idOf(finding) + ": " + finding->message + " | " + finding->hint : "";
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
