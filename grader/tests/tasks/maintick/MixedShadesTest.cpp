#include <grader/tasks/maintick/TraceModel.h>
#include <grader/tasks/maintick/mixed/MixedShades.h>
#include <grader/tasks/support/Surfaces.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ticker::tasks::maintick {
namespace {

constexpr std::uint64_t kMixedShadeSeeds = 300;

/// Whether a shadow ray that starts like this says what it should, and no hit is near the light.
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

// However the shadow ray starts, up to a bias of a thousandth.
TEST(MixedShades, KeepTheirShadowsOffTheirEdges) {
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed)
        for (const MixedShade& shade : drawMixedShades(seed)) {
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
        for (const MixedShade& shade : drawMixedShades(seed)) {
            const ColourRGB right = phong(withoutHidden(shade));
            EXPECT_TRUE(isNear(phong(withHiddenOut(shade)), right)) << seed;
            EXPECT_TRUE(isNear(phong(withoutBlocked(shade)), right)) << seed;
        }
}

/// How many hidden lights of the seed would show if they arrived, and fit.
template <class Fits>
int hiddenThat(std::uint64_t seed, const Fits& fits) {
    int count = 0;
    for (const MixedShade& shade : drawMixedShades(seed))
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

TEST(MixedShades, HaveAsManyFreeWaysAsHiddenOnes) {
    int hidden = 0;
    int free = 0;
    for (std::uint64_t seed = 0; seed < kMixedShadeSeeds; ++seed)
        for (const MixedShade& shade : drawMixedShades(seed))
            for (const Way& way : shade.ways)
                ++(way.blocker ? hidden : free);
    EXPECT_GT(hidden, 2 * free / 5);
    EXPECT_GT(free, 2 * hidden / 5);
}

}  // namespace
}  // namespace ticker::tasks::maintick
