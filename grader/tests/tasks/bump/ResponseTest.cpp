// Responses to slopes, measured on tilts made by hand.
#include <grader/tasks/bump/answers/Response.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Spread.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace ticker::tasks::bump {
namespace {

constexpr double kPi = std::numbers::pi;

/// The tilt on a ramp at a place of the map: along the slope (positive: the ramp looks raised), and
/// along the other axis.
struct Tilt {
    double towards = 0.0;
    double sideways = 0.0;
};
Tilt turned(double degrees, double strength = 1.0) {
    return {strength * std::cos(degrees * kPi / 180.0), strength * std::sin(degrees * kPi / 180.0)};
}

template <typename OnU, typename OnV>
Response measureTilts(const OnU& onU, const OnV& onV,
                      const Parametrisation& parametrisation = tests::kParametrisation) {
    std::vector<RampTilts> tilts;
    for (const Vector3& n : tests::spread(1600)) {
        const double u = parametrisation.u(n);
        const double v = parametrisation.v(n);
        const Tilt a = onU(u, v);
        const Tilt b = onV(u, v);
        const Vector3 alongU = parametrisation.alongU(n);
        const Vector3 alongV = parametrisation.alongV(n);
        tilts.push_back({n,
                         -a.towards * alongU - a.sideways * alongV,
                         {},
                         -b.towards * alongV - b.sideways * alongU,
                         {}});
    }
    return measureResponse(tilts, parametrisation);
}

Tilt rightTilt(double, double) {
    return turned(0.0);
}

TEST(Response, OfARightReadingIsTheIdentity) {
    for (const bool mirrored : {false, true}) {
        const Response response =
            measureTilts([](double, double) { return turned(0.0, 3.0); }, rightTilt,
                         Parametrisation(Vector3{0.6, 0.0, 0.8}, 0.2, mirrored));
        EXPECT_EQ(response.u.sense, Sense::right);
        EXPECT_EQ(response.v.sense, Sense::right);
        EXPECT_EQ(response.u.shares.right, 1.0);
        EXPECT_EQ(response.u.sign(), 1.0);
        EXPECT_NEAR(response.matrix[0][0], 1.0, 1e-9);
        EXPECT_NEAR(response.matrix[0][1], 0.0, 1e-9);
        EXPECT_NEAR(response.matrix[1][0], 0.0, 1e-9);
        EXPECT_NEAR(response.matrix[1][1], 1.0, 1e-9);
        EXPECT_NEAR(response.u.strengthRatio, 1.0, 1e-9);
        EXPECT_NEAR(response.u.bandStrength[0], 3.0, 1e-9);
        EXPECT_NEAR(response.v.bandStrength[7], 1.0, 1e-9);
        EXPECT_EQ(response.u.bandsThatTurn, 0);
        EXPECT_FALSE(response.dependsOnLongitude());
    }
}

TEST(Response, KnowsInvertedAcrossAndDead) {
    const auto inverted = [](double, double) { return turned(180.0); };
    const auto across = [](double u, double) { return turned(u < 0.5 ? 90.0 : -90.0); };
    const auto dead = [](double, double) { return turned(0.0, 0.9e-4); };
    const Response one = measureTilts(inverted, across);
    EXPECT_EQ(one.u.sense, Sense::inverted);
    EXPECT_EQ(one.u.sign(), -1.0);
    EXPECT_NEAR(one.matrix[0][0], -1.0, 1e-9);
    EXPECT_EQ(one.v.sense, Sense::across);
    EXPECT_NEAR(one.v.shares.across, 1.0, 1e-9);
    const Response two = measureTilts(dead, rightTilt);
    EXPECT_EQ(two.u.sense, Sense::dead);
    EXPECT_EQ(two.u.shares.dead, 1.0);
    const auto faint = [](double, double) { return turned(0.0, 1.1e-4); };
    EXPECT_EQ(measureTilts(faint, rightTilt).u.sense, Sense::right);
}

TEST(Response, LeavesPointsWithoutATiltOutOfTheStrengths) {
    for (const double share : {0.3, 0.5, 0.7}) {
        const Response half = measureTilts(
            [=](double u, double) { return turned(0.0, u < share ? 0.0 : 1.0); }, rightTilt);
        EXPECT_NEAR(half.u.strengthRatio, 1.0, 1e-9) << share;
        EXPECT_NEAR(half.u.shares.dead, share, 0.05);
        EXPECT_FALSE(half.dependsOnLongitude());
    }
}

TEST(Response, HasTheDirectionOfEveryBandAndTheFarthest) {
    const Response response = measureTilts(
        [](double, double v) { return turned(v < 0.5 ? 40.0 : -50.0, 2.0); }, rightTilt);
    EXPECT_EQ(response.u.sense, Sense::mixed);
    EXPECT_EQ(response.u.shares.right + response.u.shares.across, 0.0) << "in between";
    EXPECT_NEAR(response.u.bandDirection[1], 40.0, 1e-6);
    EXPECT_NEAR(response.u.bandDirection[6], -50.0, 1e-6);
    EXPECT_NEAR(response.u.worstDirection, -50.0, 1e-6);
    EXPECT_GT(tests::kParametrisation.v(response.u.worst), 0.5);
    EXPECT_EQ(response.u.bandsThatTurn, 0);
    EXPECT_FALSE(response.dependsOnLongitude());
    const double mean = 0.5 * (std::cos(40.0 * kPi / 180.0) + std::cos(50.0 * kPi / 180.0));
    EXPECT_NEAR(response.matrix[0][0], mean, 0.01);
    EXPECT_NEAR(response.matrix[0][1],
                0.5 * (std::sin(40.0 * kPi / 180.0) - std::sin(50.0 * kPi / 180.0)), 0.01);
}

TEST(Response, AllowsFifteenDegreesEitherWay) {
    for (const double middle : {0.0, 180.0, 90.0, -90.0})
        for (const double north : {-1.0, 1.0}) {
            const auto off = [&](double by) {
                return measureTilts(
                           [&](double, double v) {
                               return turned(middle + (v < 0.5 ? north : -north) * by);
                           },
                           rightTilt)
                    .u.sense;
            };
            EXPECT_NE(off(14.9), Sense::mixed) << middle;
            EXPECT_EQ(off(15.1), Sense::mixed) << middle;
        }
}

// If a slope along u also tilts along v, all tilts turn the same way.
TEST(Response, AllowsNoLeanOfAllTilts) {
    for (const double middle : {0.0, 180.0})
        for (const double side : {-1.0, 1.0}) {
            const auto leaning = [&](double by) {
                return measureTilts([&](double, double) { return turned(middle + side * by); },
                                    rightTilt)
                    .u.sense;
            };
            EXPECT_NE(leaning(2.0), Sense::mixed) << middle;
            EXPECT_EQ(leaning(3.0), Sense::mixed) << middle;
        }
}

TEST(Response, ForgivesAPointInAHundredButNoMore) {
    const auto deadWhere = [](double below, double strength = 0.009) {
        return measureTilts(
            [=](double u, double) { return turned(0.0, u < below ? strength : 1.0); }, rightTilt);
    };
    const Response few = deadWhere(0.022);  // of which the first 0.012 are left out
    EXPECT_GT(few.u.shares.dead, 0.005);
    EXPECT_EQ(few.u.sense, Sense::right);
    EXPECT_LT(tests::kParametrisation.u(few.u.deadAt), 0.022);
    const Response many = deadWhere(0.04);
    EXPECT_EQ(many.u.sense, Sense::mixed);
    EXPECT_NEAR(many.u.shares.dead, 0.028, 0.006);
    EXPECT_EQ(deadWhere(0.04, 0.011).u.shares.dead, 0.0);
}

TEST(Response, LeavesOutSeamAndPoles) {
    const auto wrongWhere = [](auto isWrong) {
        return 1.0 -
               measureTilts([&](double u, double v) { return turned(isWrong(u, v) ? 180.0 : 0.0); },
                            rightTilt)
                   .u.shares.right;
    };
    EXPECT_EQ(wrongWhere([](double u, double) { return u < 0.0119; }), 0.0);
    EXPECT_EQ(wrongWhere([](double u, double) { return u > 1.0 - 0.0119; }), 0.0);
    EXPECT_EQ(wrongWhere([](double, double v) { return v < 0.044; }), 0.0);
    EXPECT_EQ(wrongWhere([](double, double v) { return v > 1.0 - 0.044; }), 0.0);
    EXPECT_GT(wrongWhere([](double u, double) { return u < 0.02; }), 0.0);
    EXPECT_GT(wrongWhere([](double, double v) { return v < 0.06; }), 0.0);
    EXPECT_GT(wrongWhere([](double, double v) { return v > 0.94; }), 0.0);
}

TEST(Response, LeavesOutWhatIsNoNumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Response response = measureTilts(
        [&](double u, double) {
            return u < 0.3 ? Tilt{nan, 0.0} : turned(0.0);
        },
        rightTilt);
    EXPECT_EQ(response.u.shares.right, 1.0);
}

TEST(Response, SeesASignThatChangesRoundTheSphere) {
    const Response response =
        measureTilts([](double u, double) { return turned(u < 0.5 ? 0.0 : 180.0); }, rightTilt);
    EXPECT_EQ(response.u.bandsThatTurn, 8);
    EXPECT_TRUE(response.dependsOnLongitude());
    const Response other =
        measureTilts(rightTilt, [](double u, double) { return turned(u < 0.5 ? 0.0 : 180.0); });
    EXPECT_TRUE(other.dependsOnLongitude());
    const auto bands = [](double most) {
        return measureTilts(
            [=](double u, double v) { return turned(u < 0.5 && v < most ? 180.0 : 0.0); },
            rightTilt);
    };
    EXPECT_FALSE(bands(2.0 / 8.0).dependsOnLongitude()) << "in two bands";
    EXPECT_TRUE(bands(3.0 / 8.0).dependsOnLongitude()) << "in three";
    const Response one = measureTilts(
        [](double u, double) { return turned(u < 1.0 / 8.0 ? 180.0 : 0.0); }, rightTilt);
    EXPECT_EQ(one.u.bandsThatTurn, 0) << "in one sector of eight";
}

TEST(Response, SeesAStrengthThatChangesRoundTheSphere) {
    const auto ratio = [](double times) {
        return measureTilts(
            [=](double u, double v) { return turned(0.0, (u < 0.25 ? times : 1.0) * (1.0 + v)); },
            rightTilt);
    };
    EXPECT_NEAR(ratio(2.0).u.strengthRatio, 2.0, 0.1);
    EXPECT_TRUE(ratio(2.0).dependsOnLongitude());
    EXPECT_FALSE(ratio(1.6).dependsOnLongitude());
    EXPECT_NEAR(ratio(0.5).u.strengthRatio, 2.0, 0.1);
    EXPECT_NEAR(ratio(9.0).u.strengthRatio, 4.0, 0.1) << "single points count up to four times";
    const Response other =
        measureTilts(rightTilt, [](double u, double) { return turned(0.0, u < 0.25 ? 2.0 : 1.0); });
    EXPECT_TRUE(other.dependsOnLongitude());
    EXPECT_NEAR(ratio(1.0).u.strengthRatio, 1.0, 0.02) << "latitude does not count";
}

TEST(Response, FindsTangentsOfAnotherLongitudeToTenDegrees) {
    for (const bool mirrored : {false, true})
        for (const bool crossed : {false, true})
            for (const double degrees : {60.0, -40.0, 180.0}) {
                const Parametrisation parametrisation({0.0, 1.0, 0.0}, 0.5, mirrored);
                const double turns = (mirrored ? -degrees : degrees) / 360.0;
                const double sense = mirrored ? -1.0 : 1.0;
                std::vector<RampTilts> tilts;
                for (const Vector3& n : tests::spread(800)) {
                    const Vector3 there = parametrisation.direction(parametrisation.u(n) + turns,
                                                                    parametrisation.v(n));
                    const Vector3 alongU = parametrisation.alongU(there);
                    const Vector3 alongV = parametrisation.alongV(there);
                    tilts.push_back({n,
                                     crossed ? n.cross(alongV) * sense : -alongU,
                                     {},
                                     crossed ? alongU.cross(n) * sense : -alongV,
                                     {}});
                }
                EXPECT_NEAR(measureResponse(tilts, parametrisation).tangentTurn, degrees, 10.0)
                    << mirrored << crossed;
            }
    EXPECT_EQ(measureTilts(rightTilt, rightTilt).tangentTurn, 0.0);
}

TEST(StrengthAt, LiesOnTheLineBetweenTheMiddlesOfTheBands) {
    AxisResponse axis;
    for (std::size_t band = 0; band < kBands; ++band)
        axis.bandStrength[band] = 1.0 + static_cast<double>(band * band);
    EXPECT_NEAR(strengthAt(axis, 2.5 / 8.0), 5.0, 1e-9);
    EXPECT_NEAR(strengthAt(axis, 2.75 / 8.0), 5.0 + 0.25 * 5.0, 1e-9);
    EXPECT_NEAR(strengthAt(axis, 0.0), 1.0, 1e-9);
    EXPECT_NEAR(strengthAt(axis, 1.0), 50.0, 1e-9);
    EXPECT_NEAR(strengthAt(axis, 7.25 / 8.0), 37.0 + 0.75 * 13.0, 1e-9);
}

}  // namespace
}  // namespace ticker::tasks::bump
