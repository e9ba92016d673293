#include <grader/tasks/maintick/TraceModel.h>
#include <grader/tasks/maintick/mixed/MixedShades.h>
#include <grader/tasks/support/Surfaces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

constexpr std::uint64_t kMixedShadeSeeds = 300;

/// The shades of a seed, drawn once for all tests.
const std::vector<MixedShade>& shadesOf(std::uint64_t seed) {
    static const auto kDrawn = [] {
        std::vector<std::vector<MixedShade>> drawn;
        for (std::uint64_t each = 0; each < kMixedShadeSeeds; ++each)
            drawn.push_back(drawMixedShades(each));
        return drawn;
    }();
    return kDrawn.at(seed);
}

/// Expects that a shadow ray that starts at P + `up` is blocked exactly if the light is hidden, and
/// that its hit is near neither the light nor its start.
void expectTold(const MixedShade& shade, const Way& way, const Vector3& up) {
    constexpr double kOffEdge = 0.01;
    const LitSetup& alone = shade.point.alone;
    const Vector3 path = alone.scene.pointLights[way.light].position() - alone.P;
    const auto hit = nearestOn(shade.point.scene, {alone.P + up, path.normalised()});
    const double before = hit ? path.magnitude() - hit->meeting.distance : -1.0;
    EXPECT_EQ(before > 0.0, way.blocker.has_value());
    EXPECT_GT(std::abs(before), kOffEdge);
    if (!hit || before < 0.0) return;
    EXPECT_GT(hit->meeting.distance, kOffEdge);
}

// Shadow rays may start with any bias up to a thousandth, along the normal or towards the light.
TEST(MixedShades, KeepTheirShadowsOffTheirEdges) {
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed)
        for (const MixedShade& shade : shadesOf(seed)) {
            SCOPED_TRACE(seed);
            const LitSetup& alone = shade.point.alone;
            for (const Way& way : shade.ways) {
                const Vector3 path = alone.scene.pointLights[way.light].position() - alone.P;
                EXPECT_GT(path.dot(alone.N), 0.0);
                for (const double bias : {1e-6, 1e-4, 1e-3}) {
                    expectTold(shade, way, alone.N * bias);
                    expectTold(shade, way, path.normalised() * bias);
                }
            }
        }
}

TEST(MixedShades, AreRightAloneWithoutTheHiddenLights) {
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed)
        for (const MixedShade& shade : shadesOf(seed)) {
            const ColourRGB right = phong(withoutHidden(shade));
            EXPECT_TRUE(isNear(phong(withHiddenOut(shade)), right)) << seed;
            EXPECT_TRUE(isNear(phong(withoutBlocked(shade)), right)) << seed;
        }
}

/// How many hidden lights of the seed fit and would change the colour clearly if they arrived.
template <class Fits>
int hiddenThat(std::uint64_t seed, const Fits& fits) {
    int count = 0;
    for (const MixedShade& shade : shadesOf(seed))
        for (const Way& way : shade.ways) {
            if (!way.blocker || !fits(shade, way)) continue;
            LitSetup lit = withoutHidden(shade);
            lit.scene.pointLights.push_back(shade.point.alone.scene.pointLights[way.light]);
            count += isNear(phong(lit), phong(withoutHidden(shade)), 3.0 * kTolerance) ? 0 : 1;
        }
    return count;
}

TEST(MixedShades, HideLightsByEachKindOfObjectUnderEverySeed) {
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const auto ofBlocker = [&](auto&& fits) {
            return hiddenThat(seed, [&](const MixedShade& shade, const Way& way) {
                return fits(tasks::materialOf(shade.point.scene, *way.blocker));
            });
        };
        for (const double share : {0.0, 0.03, 0.5, 0.97, 1.0})
            EXPECT_GE(ofBlocker([&](const auto& m) { return m.reflectivity == share; }), 1);
        EXPECT_GE(ofBlocker([](const auto& m) { return m.colour == ColourRGB{}; }), 1);
        EXPECT_GE(ofBlocker([](const auto& m) { return m.colour != ColourRGB{}; }), 5);
        EXPECT_GE(hiddenThat(seed,
                             [](const MixedShade& s, const Way& w) {
                                 return *w.blocker >=
                                        static_cast<int>(s.point.scene.spheres.size());
                             }),
                  1);
        EXPECT_GE(hiddenThat(seed, [](const MixedShade&, const Way& w) { return w.light > 0; }), 2);
        EXPECT_GE(hiddenThat(seed, [](const MixedShade& s,
                                      const Way&) { return s.point.alone.P.z < 0.0; }),
                  1);
    }
}

/// Expects under every seed a hidden light for which `holds`: code that casts no shadow on this
/// condition shows there.
template <class Holds>
void expectShown(const char* what, const Holds& holds) {
    int unseen = 0;
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed) {
        const int shown = hiddenThat(seed, [&](const MixedShade& shade, const Way& way) {
            return holds(shade, way, shade.point.alone.scene.spheres[0].material);
        });
        unseen += shown > 0 ? 0 : 1;
    }
    EXPECT_EQ(unseen, 0) << what;
}

TEST(MixedShades, ShowAnyConditionOnTheSurface) {
    using S = MixedShade;
    using M = raytracer::Material;
    for (const double share : {0.0, 0.03, 0.5, 0.97, 1.0})
        expectShown("share",
                    [&](const S&, const Way&, const M& m) { return m.reflectivity == share; });
    for (const double alpha : {1.0, 2.0, 7.0, 40.0, 280.0})
        expectShown("alpha",
                    [&](const S&, const Way&, const M& m) { return m.phongAlpha == alpha; });
    for (const double kd : {0.0, 0.5, 1.0, 2.0})
        expectShown("kd", [&](const S&, const Way&, const M& m) { return m.phongKD == kd; });
    for (const double ks : {0.0, 0.5, 1.4})
        expectShown("ks", [&](const S&, const Way&, const M& m) { return m.phongKS == ks; });
    expectShown("black", [](const S&, const Way&, const M& m) { return m.colour == ColourRGB{}; });
    expectShown("plane", [](const S& s, const Way&, const M&) { return s.point.isOnPlane; });
    expectShown("z", [](const S& s, const Way&, const M&) { return s.point.alone.P.z < 0.0; });
    expectShown(
        "far", [](const S& s, const Way&, const M&) { return s.point.alone.P.magnitude() > 20.0; });
    expectShown("no ambient light", [](const S& s, const Way&, const M&) {
        return s.point.scene.ambientLighting == ColourRGB{};
    });
}

TEST(MixedShades, ShowAnyConditionOnTheLight) {
    using S = MixedShade;
    using M = raytracer::Material;
    for (const std::size_t light : {0U, 1U, 2U, 3U})
        expectShown("light", [&](const S&, const Way& w, const M&) { return w.light == light; });
    const auto ofLight = [&](const char* what, auto&& fits) {
        expectShown(what, [&](const S& s, const Way& w, const M&) {
            const raytracer::PointLight& light = s.point.scene.pointLights[w.light];
            const double distance = (light.position() - s.point.alone.P).magnitude();
            const ColourRGB I = light.illuminationAt(distance);
            return fits(light, distance, std::max({I.r, I.g, I.b}));
        });
    };
    using L = raytracer::PointLight;
    ofLight("near", [](const L&, double d, double) { return d < 1.0; });
    ofLight("very near", [](const L&, double d, double) { return d < 0.5; });
    ofLight("distant", [](const L&, double d, double) { return d > 20.0; });
    ofLight("faint", [](const L&, double, double most) { return most < 1.0 / 255.0; });
    ofLight("bright", [](const L&, double, double most) { return most > 10.0; });
    for (const auto channel : {&ColourRGB::r, &ColourRGB::g, &ColourRGB::b})
        ofLight("channel", [&](const L& l, double, double) { return l.colour().*channel == 0.0; });
}

TEST(MixedShades, HideAQuarterToThreeQuartersOfTheirLights) {
    int hidden = 0;
    int free = 0;
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed)
        for (const MixedShade& shade : shadesOf(seed))
            for (const Way& way : shade.ways)
                ++(way.blocker ? hidden : free);
    EXPECT_GT(hidden, 2 * free / 5);
    EXPECT_GT(free, 2 * hidden / 5);
}

}  // namespace
}  // namespace ticker::tasks::maintick
