#include <grader/lab/agreement/MomentAgreement.h>
#include <grader/oracle/BallPool.h>
#include <grader/oracle/Oracle.h>
#include <grader/tests/oracle/TestScenes.h>
#include <grader/tests/support/SlowRun.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace ticker::oracle::test {
namespace {

raytracer::RenderSettings smallSettings() {
    raytracer::RenderSettings settings;
    settings.width = 24;
    settings.height = 18;
    settings.dofFocalPlane = 4.0;
    return settings;
}

Precision good() {
    Precision precision;
    precision.share = 0.01;
    return precision;
}

double varianceSum(const Moments& moments) {
    double sum = 0.0;
    for (const Covariance& c : moments.covariance)
        sum += c.rr + c.gg + c.bb;
    return sum;
}

// 36 tiles for each of 10 comparisons: with errors from 3 degrees of freedom in each of 36 pixels
// a tile's z is nearly normal; 6 has a false-alarm probability below 1e-6 in all. The summed
// variance comes from some 1e5 paths: 5 % is more than 5 of its standard errors.
TEST(OracleTricks, ChangeNoExpectedValue) {
    const std::vector<std::pair<std::string, bool Tricks::*>> tricks{
        {"coneTests", &Tricks::coneTests},
        {"lowDiscrepancy", &Tricks::lowDiscrepancy},
        {"closedForms", &Tricks::closedForms},
        {"pairedShadows", &Tricks::pairedShadows},
        {"allocation", &Tricks::allocation}};
    std::vector<raytracer::SceneDescription> scenes{distributedScene()};
    if (tests::isSlowRun()) scenes.push_back(variedScene());
    for (const auto& scene : scenes) {
        const Moments all = Oracle{scene, smallSettings()}.moments(21, good());
        for (const auto& [name, trick] : tricks) {
            SCOPED_TRACE(name);
            Tricks without;
            without.*trick = false;
            const Moments plain =
                Oracle{scene, smallSettings(), {}, {}, without}.moments(22, good());
            EXPECT_LT(calibrate::largestTileZ(all, plain), 6.0);
            EXPECT_NEAR(varianceSum(plain) / varianceSum(all), 1.0, 0.05);
        }
    }
}

// The light's cone goes on behind it where objects behind it shade. A sphere there is far off the
// light's axis but within the cone, and hides some 4 % of the light. 2^15 rays: the difference is
// 0.002 (1 sigma) even with random points; 5 sigma, false alarm below 1e-6.
TEST(OracleTricks, SeeSpheresInTheConeBehindTheLightWhereTheyShade) {
    raytracer::SceneDescription scene;
    scene.pointLights.emplace_back(raytracer::Vector3{0.0, 0.0, 1.0}, raytracer::ColourRGB{1.0},
                                   200.0);
    scene.planes = {plane({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}, 0xffffff)};
    raytracer::RenderSettings settings;
    settings.width = settings.height = 1;
    settings.bounces = 0;
    Reading reading;
    reading.shadowReach = ShadowReach::endless;
    Precision precision;
    precision.minLensPaths = precision.maxLensPaths = 1 << 14;
    const auto brightness = [&](bool coneTests) {
        Tricks tricks;
        tricks.coneTests = coneTests;
        return Oracle{scene, settings, reading, {}, tricks}.moments(5, precision).mean[0].g;
    };
    const double unshaded = brightness(true);
    scene.spheres = {sphere({1.5, 0.0, -15.0}, 0.5, 0xffffff)};
    EXPECT_LT(brightness(true) / unshaded, 0.98);
    EXPECT_NEAR(brightness(true) / unshaded, brightness(false) / unshaded, 0.01);
}

// The claimed error of moments must match the actual error: of the difference of two estimates,
// over all pixels, with 3 degrees of freedom each.
TEST(OracleMoments, KnowTheirOwnError) {
    const Oracle oracle{variedScene(), smallSettings()};
    double claimed = 0.0;
    double found = 0.0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Moments a = oracle.moments(2 * seed, good());
        const Moments b = oracle.moments(2 * seed + 1, good());
        for (std::size_t i = 0; i < a.mean.size(); ++i) {
            const raytracer::ColourRGB off = a.mean[i] - b.mean[i];
            found += off.r * off.r + off.g * off.g + off.b * off.b;
            claimed += a.meanError[i].r + a.meanError[i].g + a.meanError[i].b;
            claimed += b.meanError[i].r + b.meanError[i].g + b.meanError[i].b;
        }
    }
    // A few dozen noisy pixels carry the sum: its own error is some 10 %.
    EXPECT_NEAR(found / claimed, 1.0, 0.4);
}

TEST(OracleMoments, ReachThePrecisionThatIsAskedFor) {
    const Moments moments = Oracle{distributedScene(), smallSettings()}.moments(1, good());
    EXPECT_LE(moments.shareOfVariance(16), 0.01);
    Precision byError;
    byError.share = 0.0;
    byError.rms = 3e-4;
    EXPECT_LE(Oracle(distributedScene(), smallSettings()).moments(1, byError).rmsError(), 3e-4);
}

// The pool must represent the ball: for any plane through it, the share of points on one side must
// match the ball's far better than a student's render could resolve.
TEST(BallPool, IsUniformInTheBall) {
    const BallPool pool{LightShape::ball, 1.0};
    for (const double height : {-0.7, -0.3, 0.0, 0.4, 0.8}) {
        const double expected = 0.25 * (1.0 + height) * (1.0 + height) * (2.0 - height);
        for (const std::vector<float>* axis : {&pool.x, &pool.y, &pool.z}) {
            double below = 0.0;
            for (const float value : *axis)
                below += (value < height ? 0.5 : 0.0) + (-value < height ? 0.5 : 0.0);
            // Random points would be 0.004 off.
            EXPECT_NEAR(below / BallPool::kSize, expected, 0.001);
        }
    }
}

}  // namespace
}  // namespace ticker::oracle::test
