// Points in the penumbra, and the shares of the light that are expected and seen there, for code
// that is judged by values alone.
#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>
#include <grader/tasks/shadows/penumbra/PenumbraHits.h>
#include <grader/tasks/shadows/penumbra/PenumbraShares.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ticker::tasks {
namespace {

using Kind = PenumbraQuestion::Place::Kind;

const PenumbraQuestion& oneQuestion() {
    static const PenumbraQuestion drawn = drawPenumbraQuestion(5);
    return drawn;
}

/// How many of 3000 aims on a sphere around the light are visible.
/// @param size  Radius of the sphere, in radii of the light.
int openAims(const probe::LitPoint& point, double size) {
    const Surfaces surfaces{oneQuestion().question.scene};
    const Vector3 light = oneQuestion().question.scene.pointLights[0].position();
    const Vector3 start = point.position + point.normal * 1e-4;
    Draw draw{3, 9};
    int open = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vector3 towards = light + draw.direction() * (0.4 * size) - start;
        const double reach = towards.magnitude();
        open += surfaces.sightAlong(start, towards / reach, reach) == Sight::blocked ? 0 : 1;
    }
    return open;
}

/// What all places of a kind have in common. Sizes are in radii of the light.
struct PlacesOfKind {
    std::size_t number;
    std::size_t calls;      ///< of each
    double unseenSize = 0;  ///< of a light that would not be seen at all
    double seenSize = 1;    ///< of one that would be seen in part
};
const std::map<Kind, PlacesOfKind> kPlaces{{Kind::penumbra, {12, 2000}},
                                           {Kind::beyondRim, {3, 1000, 1.02, 1.2}},
                                           {Kind::withinRim, {3, 1000, 0.81}},
                                           {Kind::atRim, {3, 3000, 0.95}}};

TEST(PenumbraQuestion, AsksWhereAPartIsSeenAndBesideTheRim) {
    std::map<Kind, std::size_t> found;
    std::size_t next = 0;
    for (const PenumbraQuestion::Place& place : oneQuestion().places) {
        ++found[place.kind];
        const PlacesOfKind& expected = kPlaces.at(place.kind);
        EXPECT_EQ(place.first, next);
        EXPECT_EQ(place.calls, expected.calls);
        next += place.calls;
        const probe::LitPoint& point = oneQuestion().question.points[place.first];
        EXPECT_EQ(place.fromLens, point.viewer.z == 0.0);
        const Vector3 moved = oneQuestion().question.points[next - 1].position - point.position;
        EXPECT_TRUE(moved.magnitude() > 0.0 && moved.magnitude() < 4e-6);
        EXPECT_LT(std::abs(moved.dot(point.normal)), 1e-9) << "in the floor";
        if (place.kind == Kind::penumbra) {
            EXPECT_GT(openAims(point, 1.0), 90) << "more than no light";
            EXPECT_LT(openAims(point, 1.0), 2940) << "less than all";
            continue;
        }
        EXPECT_EQ(openAims(point, expected.unseenSize), 0);
        EXPECT_GT(openAims(point, expected.seenSize), 0);
    }
    EXPECT_EQ(next, oneQuestion().question.points.size());
    for (const auto& [kind, expected] : kPlaces)
        EXPECT_EQ(found[kind], expected.number) << static_cast<int>(kind);
}

/// Values of code that subtracts a tenth of the light for each ray that meets the occluder.
/// @param times  How often a ray counts again if it also meets the sphere inside.
std::vector<PenumbraSamples> lessEveryHit(double times) {
    const PenumbraQuestion& asked = oneQuestion();
    raytracer::SceneDescription small = asked.question.scene;
    small.spheres.erase(small.spheres.begin());
    const Surfaces both{asked.question.scene};
    const Surfaces inner{small};
    Draw draw{4, 9};
    std::vector<PenumbraSamples> seen;
    for (const PenumbraQuestion::Place& place : asked.places) {
        if (place.kind != Kind::penumbra) continue;
        PenumbraSamples& samples = seen.emplace_back();
        samples.place = place;
        samples.point = asked.question.points[place.first];
        const Vector3 start = samples.point.position + samples.point.normal * 1e-4;
        for (int call = 0; call < 400; ++call) {
            double share = 1.0;
            for (int ray = 0; ray < 10; ++ray) {
                const Vector3 aim = draw.direction() * (0.4 * std::cbrt(draw.between(0.0, 1.0)));
                const Vector3 way = asked.question.scene.pointLights[0].position() + aim - start;
                const auto isBlocked = [&](const Surfaces& by) {
                    const double reach = way.magnitude();
                    return by.sightAlong(start, way / reach, reach) == Sight::blocked;
                };
                share -= (isBlocked(both) ? 0.1 : 0.0) + (isBlocked(inner) ? 0.1 * times : 0.0);
            }
            samples.mean += std::max(0.0, share) / 400.0;
        }
    }
    return seen;
}

// Means of 400 calls are off by 0.05 with a chance below 1e-5 for each of twelve places.
TEST(CountsEveryHit, KnowsRaysThatCountForTwoObjects) {
    PenumbraExpectations expectations{oneQuestion()};
    EXPECT_TRUE(countsEveryHit(expectations, lessEveryHit(1.0)));
    EXPECT_FALSE(countsEveryHit(expectations, lessEveryHit(0.0)));
    EXPECT_EQ(everyHitCounts().id, "shadow.wrong");
}

TEST(PenumbraExpectations, AreComputedOnceForEachPlaceShapeAndSize) {
    const PenumbraQuestion& asked = oneQuestion();
    PenumbraExpectations expectations{asked};
    const PenumbraQuestion::Place& place = asked.places.front();
    const ExpectedShares* ball = &expectations.at(place, AimShape::ball);
    EXPECT_EQ(ball->open, expectedAt(asked.question, Surfaces{asked.question.scene},
                                     asked.question.points[place.first], AimShape::ball, 1.0)
                              .open);
    EXPECT_NE(&expectations.at(asked.places.back(), AimShape::ball), ball);
    EXPECT_NE(&expectations.at(place, AimShape::surface), ball);
    EXPECT_NE(&expectations.at(place, AimShape::ball, 0.5), ball);
    EXPECT_EQ(&expectations.at(place, AimShape::ball), ball);
}

PenumbraSamples samplesOf(std::size_t calls, double mean, double variance) {
    PenumbraSamples samples;
    samples.shares.assign(calls, mean);
    samples.mean = mean;
    samples.variance = variance;
    return samples;
}

/// Bernstein's bound for one place whose share is known to 0.0025.
double boundOf(double variance, double calls) {
    const double risk = std::log(2.0 / 1e-11);
    return std::sqrt(2.0 * (1.5 * variance + 0.002) / calls * risk) + risk / calls / 3.0 + 0.0025;
}

TEST(WorstExcess, IsInUnitsOfBernsteinsBound) {
    const std::vector<PenumbraSamples> one{samplesOf(1000, 0.35, 0.02)};
    EXPECT_NEAR(worstExcess(one, {0.3}, {0.5}), 0.05 / boundOf(0.02, 1000.0), 1e-9);
    // Together the two places are twice as far off, and the bound grows by less.
    const std::vector<PenumbraSamples> two{samplesOf(1000, 0.35, 0.02),
                                           samplesOf(1000, 0.45, 0.02)};
    const double risk = std::log(2.0 / 1e-11);
    const double both =
        std::sqrt(2.0 * 2.0 * 0.032 / 1000.0 * risk) + risk / 1000.0 / 3.0 + 2.0 * 0.0025;
    EXPECT_NEAR(worstExcess(two, {0.3, 0.4}, {0.5, 0.5}), 0.1 / both, 1e-9);
    EXPECT_NEAR(worstExcess(two, {0.4, 0.4}, {0.5, 0.5}), 0.05 / boundOf(0.02, 1000.0), 1e-9);
    // Every share moves towards one half, as with a larger light.
    const double wider = std::sqrt(2.0 * 2.0 * 0.04 * 0.032 / 1000.0 * risk) +
                         0.2 * risk / 1000.0 / 3.0 + 2.0 * 0.2 * 0.0025;
    EXPECT_NEAR(worstExcess(two, {0.3, 0.5}, {0.3, 0.7}), 2.0 * 0.2 * 0.05 / wider, 1e-9);
}

TEST(ReadSamples, AreSharesOfTheLightWithMeanAndVariance) {
    PenumbraQuestion asked = oneQuestion();
    const PenumbraQuestion::Place place{Kind::penumbra, false, 1, 2};
    PointLog log;
    log.point = asked.question.points[1];
    log.lines.resize(1);
    const ColourRGB ambient = ambientPart(log, asked.question.scene);
    const ColourRGB full = unshadowed(log, asked.question.scene, 0, false);
    probe::IlluminateAnswer answer;
    answer.colours = {{}, ambient + full * 0.25, ambient + full * 0.75, {}};
    const PenumbraSamples samples = readSamples(asked, answer, place);
    ASSERT_EQ(samples.shares.size(), 2U);
    EXPECT_NEAR(samples.shares[0], 0.25, 1e-12);
    EXPECT_NEAR(samples.mean, 0.5, 1e-12);
    EXPECT_NEAR(samples.variance, 0.125, 1e-12);
}

TEST(ExpectedAt, IsAllOfTheLightWhereNothingStandsBetween) {
    ShadowByHand made;
    const ShadowQuestion& asked = made.ask(ShadowQuestion::Purpose::oneLight, {{0.0, 20.0, 0.0}});
    const Surfaces surfaces{asked.question.scene};
    probe::LitPoint point{0, {5.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-5.0, 20.0, 2.0}};
    const ExpectedShares shares = expectedAt(asked.question, surfaces, point, AimShape::ball, 1.0);
    EXPECT_NEAR(shares.open, 1.0, 1e-9);
    for (const double share : shares.share[0])
        EXPECT_NEAR(share, 1.0, 0.04);
    EXPECT_NE(shares.share[0][3], shares.share[0][4]);
    EXPECT_LT(shares.share[1][0], 0.95 * shares.share[0][0]) << "no highlight towards the origin";
    EXPECT_NEAR(shares.share[1][3], shares.share[1][0], 0.01);
}

TEST(ExpectedAt, KnowsTheFalloffFromTheNearSideOfTheLight) {
    ShadowByHand made;
    const ShadowQuestion& asked = made.ask(ShadowQuestion::Purpose::oneLight, {{0.0, 20.0, 0.0}});
    const Surfaces surfaces{asked.question.scene};
    probe::LitPoint point{0, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-5.0, 20.0, 2.0}};
    constexpr double kRadii = 4.0;
    const ExpectedShares shares =
        expectedAt(asked.question, surfaces, point, AimShape::flatDisc, kRadii);
    // Over an even disc the depth of the near side has the mean 2/3 of the radius.
    const double depth = 2.0 / 3.0 * kRadii * asked.question.settings.lightSize / 20.0;
    EXPECT_NEAR(shares.share[0][0], 1.0, 1e-9);
    EXPECT_NEAR(shares.share[0][2], 1.0 / ((1.0 - depth) * (1.0 - depth)), 0.006);
    EXPECT_GT(shares.share[0][2], shares.share[0][1]);
    EXPECT_GT(shares.share[0][5], shares.share[0][4]);
}

}  // namespace
}  // namespace ticker::tasks
