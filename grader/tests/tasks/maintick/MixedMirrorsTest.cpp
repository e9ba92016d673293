#include <grader/tasks/maintick/mixed/MixedMirrors.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace ticker::tasks::maintick {
namespace {

constexpr std::uint64_t kMixedMirrorSeeds = 300;

// Mirrored rays may start with any bias up to a thousandth, along the normal or along the ray.
TEST(MixedMirrors, KeepTheirChainsAndTheirLightWhereverMirroredRaysStart) {
    for (std::uint64_t seed = 0; seed < kMixedMirrorSeeds; ++seed)
        for (const MixedMirror& mirror : drawMixedMirrors(seed)) {
            SCOPED_TRACE(seed);
            const auto direct = directOf(mirror.scene, mirror.links);
            for (const MirrorStart& start :
                 {MirrorStart{1e-6, false}, MirrorStart{5e-4, false}, MirrorStart{1e-3, false},
                  MirrorStart{1e-6, true}, MirrorStart{1e-3, true}}) {
                const auto links = linksOf(mirror.scene, mirror.ray, start);
                ASSERT_EQ(links.size(), mirror.links.size());
                for (std::size_t i = 0; i < links.size(); ++i)
                    EXPECT_EQ(links[i].object, mirror.links[i].object);
                const auto moved = directOf(mirror.scene, links);
                const double tolerance =
                    mirror.scene.pointLights.empty() ? kTolerance / 4.0 : kMirrorTolerance * 0.8;
                for (int bounces = 0; bounces <= kMostMixedBounces; ++bounces)
                    EXPECT_TRUE(isNear(alongLinks(mirror, moved, bounces),
                                       alongLinks(mirror, direct, bounces), tolerance));
            }
        }
}

TEST(MixedMirrors, AreMetFromTheirFrontWellOffTheirRims) {
    for (std::uint64_t seed = 0; seed < kMixedMirrorSeeds; ++seed)
        for (const MixedMirror& mirror : drawMixedMirrors(seed)) {
            SCOPED_TRACE(seed);
            for (const MirrorLink& link : mirror.links)
                EXPECT_LT((link.P - link.O).normalised().dot(link.N), -0.049);
            const Perpendiculars sides = perpendicularsOf(mirror.ray.direction);
            for (const Vector3& aside : {sides.first, -sides.first, sides.second, -sides.second}) {
                const auto moved = linksOf(
                    mirror.scene, {mirror.ray.origin + aside * 0.01, mirror.ray.direction}, {});
                ASSERT_FALSE(moved.empty());
                EXPECT_EQ(moved.front().object, mirror.links.front().object);
            }
        }
}

/// Whether some ray's chain has this share at this place.
bool hasShare(const std::vector<MixedMirror>& mirrors, std::size_t place, double share,
              std::size_t length = 0) {
    return std::ranges::any_of(mirrors, [&](const MixedMirror& mirror) {
        if (mirror.links.size() <= place || mirror.links[place].share != share) return false;
        for (std::size_t i = 0; i < place; ++i)
            if (mirror.links[i].share == 0.0) return false;  // nothing is seen behind it
        return length == 0 || mirror.links.size() == length;
    });
}

TEST(MixedMirrors, HaveEachShareAtTheFirstPlacesUnderEverySeed) {
    for (std::uint64_t seed = 0; seed < kMixedMirrorSeeds; ++seed) {
        SCOPED_TRACE(seed);
        const auto mirrors = drawMixedMirrors(seed);
        for (const double share : {0.0, 0.03, 0.5, 0.97, 1.0})
            for (const std::size_t place : {0U, 1U})
                EXPECT_TRUE(hasShare(mirrors, place, share)) << place << ": " << share;
        EXPECT_TRUE(hasShare(mirrors, 2, 1.0));
        const auto count = [&](auto&& fits) { return std::ranges::count_if(mirrors, fits); };
        EXPECT_GE(count([](const MixedMirror& m) {
                      return m.links.size() < kMostLinks && m.links.back().share == 1.0;
                  }),
                  1);
        EXPECT_GE(count([](const MixedMirror& m) { return m.scene.pointLights.empty(); }), 10);
        EXPECT_GE(count([](const MixedMirror& m) { return !m.scene.pointLights.empty(); }), 5);
        EXPECT_GE(count([](const MixedMirror& m) { return m.links.front().P.z < 0.0; }), 6);
        EXPECT_GE(count([](const MixedMirror& m) { return m.links.size() == kMostLinks; }), 2);
    }
}

TEST(MixedMirrors, HaveABlackOneFirstUnderEverySeed) {
    // The grader is built by GCC. Clang takes the draws of one expression in another order, and
    // under one of its seeds no first mirror is black.
#ifdef __clang__
    constexpr int kWithout = 1;
#else
    constexpr int kWithout = 0;
#endif
    int without = 0;
    for (std::uint64_t seed = 0; seed < kMixedMirrorSeeds; ++seed)
        if (std::ranges::none_of(drawMixedMirrors(seed), [](const MixedMirror& m) {
                return tasks::materialOf(m.scene, m.links.front().object).colour == ColourRGB{};
            }))
            ++without;
    EXPECT_EQ(without, kWithout);
}

TEST(MixedMirrors, BlendAlongTheirLinks) {
    MixedMirror mirror;
    mirror.links = {{0, 0.5, {}, {}, {}}, {1, 1.0, {}, {}, {}}, {2, 0.0, {}, {}, {}}};
    const std::vector<ColourRGB> direct{ColourRGB{0.2}, ColourRGB{0.4}, ColourRGB{0.8}};
    EXPECT_NEAR(alongLinks(mirror, direct, 0).r, 0.2, 1e-12);
    EXPECT_NEAR(alongLinks(mirror, direct, 1).r, 0.3, 1e-12);
    for (const int bounces : {2, 3, 4})
        EXPECT_NEAR(alongLinks(mirror, direct, bounces).r, 0.5, 1e-12);
    mirror.links.pop_back();
    EXPECT_NEAR(alongLinks(mirror, direct, 1).r, 0.3, 1e-12);
    EXPECT_NEAR(alongLinks(mirror, direct, 2).r, 0.1005, 1e-12);
}

}  // namespace
}  // namespace ticker::tasks::maintick
