#include <grader/tasks/maintick/TraceModel.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

/// The right way, the way without mirrors, and the rows of traceMistakes() in their order.
enum class Way : std::size_t {
    right,
    noMirror,
    black,
    blackMirrored,
    directWhereMirroredMisses,
    notNegated,
    straightOn,
    straightBack,
    alongNormal,
    startAtOrigin,
    startBelow,
    notLowered,
    oneLess,
    oneMore,
    once,
    twoSpent,
    plusWhole,
    sharesExchanged,
    wholeDirect,
    wholeMirrored,
    directLost,
    mirroredAlone,
    evenShares,
    timesColour,
    baseReduced,
    weakIgnored,
    weightReplaced
};

TraceWay wayOf(Way way) {
    if (way == Way::right) return {};
    if (way == Way::noMirror) return noMirrors().way;
    return traceMistakes()[static_cast<std::size_t>(way) - 2].way;
}

const ColourRGB kRed{0.2, 0.0, 0.0};
const ColourRGB kGreen{0.0, 1.0, 0.0};
const ColourRGB kNight{0.001};
const Ray kAhead{{}, {0.0, 0.0, 1.0}};

/// A red ball ahead that mirrors 0.3, and a green wall behind the ray's start that mirrors 0.1.
struct Facing {
    raytracer::SceneDescription scene;
    std::vector<ColourRGB> direct{kRed, kGreen};

    explicit Facing(double share = 0.3, double wallShare = 0.1) {
        scene.spheres.push_back({{0.0, 0.0, 5.0}, 1.0, {ColourRGB{0.5}}, nullptr});
        scene.spheres[0].material.reflectivity = share;
        scene.planes.push_back({{0.0, 0.0, -3.0}, {0.0, 0.0, 1.0}, {ColourRGB{0.25}}});
        scene.planes[0].material.reflectivity = wallShare;
    }
    void expect(Way way, int bounces, const ColourRGB& colour, const Ray& ray = kAhead) const {
        const ColourRGB given = TraceModel{scene, direct, wayOf(way)}.along(ray, bounces);
        EXPECT_NEAR(given.r, colour.r, 1e-12) << static_cast<int>(way) << ", " << bounces;
        EXPECT_NEAR(given.g, colour.g, 1e-12) << static_cast<int>(way) << ", " << bounces;
    }
};

TEST(TraceModel, GivesEveryMistakeOfBouncesItsDepth) {
    using enum Way;
    ASSERT_EQ(traceMistakes().size() + 1, static_cast<std::size_t>(weightReplaced));
    const Facing facing;
    const ColourRGB zero = kRed;
    const ColourRGB one = kRed * 0.7 + kGreen * 0.3;
    const ColourRGB two = kRed * 0.7 + (kGreen * 0.9 + kRed * 0.1) * 0.3;
    facing.expect(right, 0, zero);
    facing.expect(right, 1, one);
    facing.expect(right, 2, two);
    facing.expect(noMirror, 2, zero);
    facing.expect(oneLess, 1, zero);
    facing.expect(oneLess, 2, one);
    facing.expect(oneMore, 0, one);
    facing.expect(oneMore, 1, two);
    facing.expect(once, 2, one);
    facing.expect(once, 3, one);
    facing.expect(twoSpent, 1, one);
    facing.expect(twoSpent, 2, one);
    facing.expect(twoSpent, 3, two);
    facing.expect(baseReduced, 0, kRed * 0.7);
    facing.expect(baseReduced, 1, kRed * 0.7 + kGreen * (0.9 * 0.3));
    facing.expect(startAtOrigin, 1, one);
    facing.expect(startBelow, 1, kRed * 0.7 + kRed * 0.3);
    facing.expect(straightOn, 1, kRed * 0.7 + kRed * 0.3);
    facing.expect(weightReplaced, 0, zero);
    facing.expect(weightReplaced, 1, one);
    facing.expect(weightReplaced, 2, kRed * 0.7 + kGreen * (0.9 * 0.3) + kRed * 0.1);
}

TEST(TraceModel, GivesEveryMistakeOfSharesItsBlend) {
    using enum Way;
    const Facing facing;
    facing.expect(plusWhole, 1, kRed + kGreen);
    facing.expect(sharesExchanged, 1, kRed * 0.3 + kGreen * 0.7);
    facing.expect(wholeDirect, 1, kRed + kGreen * 0.3);
    facing.expect(wholeMirrored, 1, kRed * 0.7 + kGreen);
    facing.expect(directLost, 1, kGreen * 0.3);
    facing.expect(mirroredAlone, 1, kGreen);
    facing.expect(evenShares, 1, (kRed + kGreen) * 0.5);
    facing.expect(timesColour, 1, kRed * 0.7 + kGreen * (0.3 * 0.5));
    Facing{0.09}.expect(weakIgnored, 1, kRed);
    Facing{0.11}.expect(weakIgnored, 1, kRed * 0.89 + kGreen * 0.11);
    Facing{0.0}.expect(wholeDirect, 1, kRed);
}

TEST(TraceModel, KnowsTheBackgroundOfMissesAndOfMirroredMisses) {
    using enum Way;
    const Ray miss{{}, {1.0, 0.0, 0.0}};
    Facing open;
    open.expect(right, 1, kNight, miss);
    open.expect(black, 1, ColourRGB{0.0}, miss);
    open.expect(blackMirrored, 1, kNight, miss);
    open.scene.planes.clear();
    open.expect(right, 1, kRed * 0.7 + kNight * 0.3);
    open.expect(black, 1, kRed * 0.7);
    open.expect(blackMirrored, 1, kRed * 0.7);
    open.expect(directWhereMirroredMisses, 1, kRed);
    open.expect(weightReplaced, 1, kRed * 0.7 + kNight * 0.3);
}

// The floor is met at 45 degrees and shows the blue wall ahead; the red wall behind stands where
// rays go that come back, the night is above and below.
TEST(TraceModel, SendsWrongDirectionsElsewhere) {
    using enum Way;
    raytracer::SceneDescription scene;
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, {}});
    scene.planes.push_back({{0.0, 0.0, 6.0}, {0.0, 0.0, -1.0}, {}});
    scene.planes.push_back({{0.0, 0.0, -6.0}, {0.0, 0.0, 1.0}, {}});
    scene.planes[0].material.reflectivity = 0.5;
    const std::vector<ColourRGB> direct{ColourRGB{0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}};
    const Ray down{{}, Vector3{0.0, -1.0, 1.0}.normalised()};
    const auto seenBy = [&](Way way) {
        return TraceModel{scene, direct, wayOf(way)}.along(down, 1) * 2.0;
    };
    EXPECT_NEAR(seenBy(right).b, 1.0, 1e-12);
    EXPECT_NEAR(seenBy(straightBack).r, 1.0, 1e-12);
    EXPECT_NEAR(seenBy(alongNormal).b, 0.001, 1e-12);
    // Into the floor, which hides the wall.
    EXPECT_NEAR(seenBy(notNegated).r + seenBy(notNegated).b, 0.0, 1e-12);
    EXPECT_NEAR(seenBy(straightOn).r + seenBy(straightOn).b, 0.0, 1e-12);
}

TEST(ChainOf, NamesTheObjectsInTheirOrderAndStopsWhereAskedTo) {
    const Facing facing;
    EXPECT_EQ(chainOf(facing.scene, kAhead, 3, {}), (std::vector{0, 1, 0}));
    EXPECT_EQ(chainOf(facing.scene, kAhead, 2, {1e-3, true}), (std::vector{0, 1}));
    EXPECT_TRUE(chainOf(facing.scene, {{}, {1.0, 0.0, 0.0}}, 3, {}).empty());
    // A start below the wall's surface meets the wall again.
    EXPECT_EQ(chainOf(facing.scene, kAhead, 3, {-1e-3, false}), (std::vector{0, 0, 0}));
}

TEST(PlaneAnswer, MeetsAPlaneFromBothSidesAheadAlone) {
    const raytracer::PlaneDescription wall{{7.0, 0.0, 4.0}, {0.0, 0.0, -2.0}, {}};
    const auto hit = meet(wall, {{1.0, 0.0, 1.0}, {0.0, 0.6, 0.8}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 3.75, 1e-12);
    EXPECT_NEAR(hit->location.y, 2.25, 1e-12);
    EXPECT_NEAR(hit->normal.z, -1.0, 1e-12);
    EXPECT_NEAR(meet(wall, {{0.0, 0.0, 6.0}, {0.0, 0.0, -0.5}})->distance, 4.0, 1e-12);
    EXPECT_FALSE(meet(wall, {{0.0, 0.0, 6.0}, {0.0, 0.0, 1.0}}));
    EXPECT_FALSE(meet(wall, {{}, {1.0, 0.0, 0.0}}));
}

}  // namespace
}  // namespace ticker::tasks::maintick
