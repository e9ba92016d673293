// The intervals of colours that a replay accepts, with ends that are worked out by hand.
#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tests/tasks/shadows/ReplayCase.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ticker::tasks {
namespace {

using Phong = ShadowReading::Phong;

const ColourRGB kFull = kDiffuse + kSpecular;
using enum Sight;

/// A ray for each of these sights.
ReplayCase replayOf(const std::vector<Sight>& sights) {
    ReplayCase made;
    made.answer(std::vector<double>(sights.size(), 0.1), {});
    for (std::size_t i = 0; i < sights.size(); ++i)
        made.log.points[0].lines[0][i].toLight = sights[i];
    return made;
}

bool fitsIn(ReplayCase made, const ColourRGB& colour, ShadowArithmetic arithmetic,
            const ShadowReading& reading = {}) {
    made.log.points[0].colour = colour;
    return fits(made.log.points[0], made.log.scene(), made.log.settings(), reading, arithmetic);
}

/// Expects that the colours `at(share)` fit for shares from `least` to `most` and for no others.
template <typename At>
void expectShares(const ReplayCase& made, ShadowArithmetic arithmetic, double least, double most,
                  const At& at, const ShadowReading& reading = {}) {
    EXPECT_TRUE(fitsIn(made, at(least), arithmetic, reading));
    EXPECT_TRUE(fitsIn(made, at(0.5 * (least + most)), arithmetic, reading));
    EXPECT_TRUE(fitsIn(made, at(most), arithmetic, reading));
    EXPECT_FALSE(fitsIn(made, at(least - 0.01), arithmetic, reading));
    EXPECT_FALSE(fitsIn(made, at(most + 0.01), arithmetic, reading));
}

TEST(ReplayIntervals, LeaveOpenWhatRoundingDecides) {
    const ReplayCase made = replayOf({open, blocked, unsure, blocked});
    const auto lit = [](double s) { return kAmbient + kFull * s; };
    expectShares(made, ShadowArithmetic::right, 0.25, 0.5, lit);
    expectShares(made, ShadowArithmetic::inverted, 0.5, 0.75, lit);
    expectShares(made, ShadowArithmetic::ambientScaled, 0.25, 0.5,
                 [](double s) { return (kAmbient + kFull) * s; });
    expectShares(made, ShadowArithmetic::specularUnshadowed, 0.25, 0.5,
                 [](double s) { return kAmbient + kDiffuse * s + kSpecular; });
    expectShares(made, ShadowArithmetic::diffuseUnshadowed, 0.25, 0.5,
                 [](double s) { return kAmbient + kDiffuse + kSpecular * s; });
}

TEST(ReplayIntervals, DecideByAllByAnyAndByHalf) {
    const auto dark = [](const ReplayCase& made, ShadowArithmetic arithmetic) {
        return fitsIn(made, kAmbient, arithmetic);
    };
    const auto light = [](const ReplayCase& made, ShadowArithmetic arithmetic) {
        return fitsIn(made, kAmbient + kFull, arithmetic);
    };
    struct Row {
        ShadowArithmetic arithmetic;
        std::vector<Sight> sights;
        bool dark;
        bool light;
    };
    for (const auto& [arithmetic, sights, mayBeDark, mayBeLight] :
         {Row{ShadowArithmetic::litIfAll, {open, open, open, open}, false, true},
          Row{ShadowArithmetic::litIfAll, {open, open, open, unsure}, true, true},
          Row{ShadowArithmetic::litIfAll, {open, open, open, blocked}, true, false},
          Row{ShadowArithmetic::litIfAny, {open, blocked, blocked, blocked}, false, true},
          Row{ShadowArithmetic::litIfAny, {unsure, blocked, blocked, blocked}, true, true},
          Row{ShadowArithmetic::litIfAny, {blocked, blocked, blocked, blocked}, true, false},
          Row{ShadowArithmetic::litIfHalf, {open, open, open, blocked}, false, true},
          Row{ShadowArithmetic::litIfHalf, {open, open, blocked, blocked}, true, true},
          Row{ShadowArithmetic::litIfHalf, {open, blocked, blocked, blocked}, true, false}}) {
        const ReplayCase made = replayOf(sights);
        EXPECT_EQ(dark(made, arithmetic), mayBeDark) << static_cast<int>(arithmetic);
        EXPECT_EQ(light(made, arithmetic), mayBeLight) << static_cast<int>(arithmetic);
    }
}

TEST(ReplayIntervals, CountWhatStandsBehindTheLightOnlyWhereAsked) {
    ReplayCase made = replayOf({open, open});
    for (AimLine& line : made.log.points[0].lines[0])
        line.endlessly = Sight::blocked;
    EXPECT_TRUE(fitsIn(made, kAmbient, ShadowArithmetic::endless));
    EXPECT_TRUE(fitsIn(made, kAmbient + kFull, ShadowArithmetic::right));
}

TEST(ReplayIntervals, HoldInEveryChannelUpToTheTolerance) {
    const ReplayCase made = replayOf({open});
    const ColourRGB exact = kAmbient + kFull;
    const ColourRGB slack = toleranceAt(made.log.points[0], made.log.scene(), false);
    for (const ColourRGB& channel :
         {ColourRGB{1.0, 0.0, 0.0}, ColourRGB{0.0, 1.0, 0.0}, ColourRGB{0.0, 0.0, 1.0}})
        for (const double side : {-1.0, 1.0}) {
            const auto off = [&](double times) { return exact + slack * channel * (side * times); };
            EXPECT_TRUE(fitsIn(made, off(0.9), ShadowArithmetic::right));
            EXPECT_FALSE(fitsIn(made, off(1.1), ShadowArithmetic::right));
        }
}

TEST(ReplayIntervals, AreWholeWhereNoRayWasLogged) {
    ReplayCase made = replayOf({});
    const auto lit = [](double s) { return kAmbient + kFull * s; };
    expectShares(made, ShadowArithmetic::right, 0.0, 1.0, lit);
    expectShares(made, ShadowArithmetic::inverted, 0.0, 1.0, lit);
    expectShares(made, ShadowArithmetic::ambientScaled, 0.0, 1.0,
                 [](double s) { return (kAmbient + kFull) * s; });
    made.log.points[0].point.normal = {0.0, -1.0, 0.0};
    EXPECT_TRUE(fitsIn(made, kAmbient, ShadowArithmetic::right));
    EXPECT_FALSE(fitsIn(made, lit(0.05), ShadowArithmetic::right)) << "it faces away";
}

TEST(ReplayReadings, LeaveOutRaysToTheCentre) {
    ReplayCase made = replayOf({open, open, blocked, blocked});
    std::vector<AimLine>& lines = made.log.points[0].lines[0];
    const ShadowReading without{Phong::central, false, true, {}};
    lines[0].miss = 1.005e-4;  // the rays start 1e-4 from the point
    lines[0].direction = {0.0, 1.0, 0.0};
    EXPECT_TRUE(fitsIn(made, kAmbient + kFull * (1.0 / 3.0), ShadowArithmetic::right, without));
    EXPECT_FALSE(fitsIn(made, kAmbient + kFull * 0.5, ShadowArithmetic::right, without));
    EXPECT_TRUE(fitsIn(made, kAmbient + kFull * 0.5, ShadowArithmetic::right));
    lines[1].miss = 0.5e-4;  // a sample by chance
    EXPECT_TRUE(fitsIn(made, kAmbient + kFull * (1.0 / 3.0), ShadowArithmetic::right, without));
    lines[0].miss = lines[1].miss = 1.02e-4;
    EXPECT_TRUE(fitsIn(made, kAmbient + kFull * 0.5, ShadowArithmetic::right, without));
}

TEST(ReplayReadings, CastForEachTermApart) {
    ReplayCase made = replayOf({open, blocked, open, open});
    made.question.question.settings.shadowRayCount = 2;
    const ShadowReading apart{Phong::central, false, false, ShadowReading::Terms::halves};
    const ColourRGB colour = kAmbient + kDiffuse * 0.5 + kSpecular;
    EXPECT_TRUE(fitsIn(made, colour, ShadowArithmetic::right, apart));
    EXPECT_FALSE(fitsIn(made, colour, ShadowArithmetic::right));
    ReplayCase few = replayOf({open, blocked, blocked});
    few.question.question.settings.shadowRayCount = 2;
    EXPECT_TRUE(fitsIn(few, kAmbient + kFull * (1.0 / 3.0), ShadowArithmetic::right, apart));
}

TEST(ReplayReadings, CastForTheSpecularTermFirst) {
    using Terms = ShadowReading::Terms;
    ReplayCase made = replayOf({open, blocked, open, open});
    made.question.question.settings.shadowRayCount = 2;
    const ShadowReading reversed{.terms = Terms::halves, .specularFirst = true};
    const ColourRGB colour = kAmbient + kDiffuse + kSpecular * 0.5;
    EXPECT_TRUE(fitsIn(made, colour, ShadowArithmetic::right, reversed));
    EXPECT_FALSE(fitsIn(made, colour, ShadowArithmetic::right,
                        {Phong::central, false, false, Terms::halves}));
    for (const Terms terms : {Terms::halves, Terms::inTurns})
        EXPECT_TRUE(
            std::ranges::any_of(acceptedShadowReadings(), [&](const ShadowReading& reading) {
                return reading.terms == terms && reading.specularFirst;
            }));
}

TEST(ReplayReadings, CastForEachTermInTurns) {
    ReplayCase made = replayOf({open, open, blocked, open});
    made.question.question.settings.shadowRayCount = 2;
    const ShadowReading inTurns{Phong::central, false, false, ShadowReading::Terms::inTurns};
    const ColourRGB colour = kAmbient + kDiffuse * 0.5 + kSpecular;
    EXPECT_TRUE(fitsIn(made, colour, ShadowArithmetic::right, inTurns));
    EXPECT_FALSE(fitsIn(made, kAmbient + kFull * 0.5, ShadowArithmetic::right, inTurns));
}

TEST(ReplayReadings, CastForEachTermApartWithAnyPhongTermAndAnExtraRay) {
    using Terms = ShadowReading::Terms;
    const std::vector<ShadowReading> all = acceptedShadowReadings();
    for (const Phong phong : {Phong::central, Phong::perSample, Phong::centralFalloff})
        for (const bool withoutCentral : {false, true})
            EXPECT_TRUE(std::ranges::any_of(all, [&](const ShadowReading& reading) {
                return reading.terms == Terms::halves && reading.phong == phong &&
                       reading.withoutCentral == withoutCentral;
            }));
}

/// One ray that passes the light's centre at a distance of about `x`; the light's radius is 0.4.
class OneRay {
public:
    explicit OneRay(double x = 0.2) {
        made_.answer({x}, {});
        line().toLight = Sight::open;
    }
    [[nodiscard]] AimLine& line() { return made_.log.points[0].lines[0][0]; }
    /// Its full light, from a light in this direction and at this distance.
    [[nodiscard]] ColourRGB lit(const Vector3& towards, double distance) const {
        const raytracer::SceneDescription& scene = made_.log.scene();
        const PhongTerms terms = phongTerms(scene.planes[0].material, scene.pointLights[0],
                                            {0.0, 1.0, 0.0}, {0.0, 1.0, 0.0}, towards, distance);
        return kAmbient + terms.diffuse + terms.specular;
    }
    [[nodiscard]] bool fits(const ColourRGB& colour, Phong phong, bool nearSide = false) const {
        return fitsIn(made_, colour, ShadowArithmetic::right, {phong, false, false, {}, nearSide});
    }

private:
    ReplayCase made_;
};

TEST(ReplayReadings, TakeTheLightFromTheSamplesDirection) {
    OneRay ray;
    const Vector3 direction = ray.line().direction;
    EXPECT_TRUE(ray.fits(ray.lit(direction, 4.0), Phong::perSampleDirection));
    EXPECT_FALSE(ray.fits(ray.lit({0.0, 1.0, 0.0}, 4.0), Phong::perSampleDirection));
    EXPECT_TRUE(ray.fits(ray.lit({0.0, 1.0, 0.0}, 4.0), Phong::central));
    EXPECT_FALSE(ray.fits(ray.lit(direction, 4.0), Phong::central));
}

TEST(ReplayReadings, LeaveTheSamplesPlaceOnItsLineOpen) {
    OneRay ray;
    const Vector3 direction = ray.line().direction;
    const double along = std::sqrt(16.0 - ray.line().miss * ray.line().miss);
    const double half = std::sqrt(0.16 - ray.line().miss * ray.line().miss);
    const std::pair<Phong, Vector3> cases[] = {{Phong::perSample, direction},
                                               {Phong::centralFalloff, {0.0, 1.0, 0.0}}};
    for (const auto& [phong, towards] : cases) {
        for (const double place : {-1.0, 0.0, 1.0})
            EXPECT_TRUE(ray.fits(ray.lit(towards, along + place * half), phong)) << place;
        for (const double place : {-1.1, 1.1})
            EXPECT_FALSE(ray.fits(ray.lit(towards, along + place * half), phong)) << place;
    }
}

// The half of the surface that faces the point ends where a chord's half is radius^2 / distance.
TEST(ReplayReadings, HoldTheSamplesToTheSideThatFacesThePoint) {
    const auto fitsAt = [](double x, double place) {
        OneRay ray{x};
        const double miss = ray.line().miss;
        const double distance =
            std::sqrt(16.0 - miss * miss) + place * std::sqrt(0.16 - miss * miss);
        return ray.fits(ray.lit(ray.line().direction, distance), Phong::perSample, true);
    };
    for (const double x : {0.2, 0.397, 0.4})
        EXPECT_TRUE(fitsAt(x, -1.0)) << x;
    for (const double place : {0.0, 1.0})
        EXPECT_FALSE(fitsAt(0.2, place)) << place;
    EXPECT_FALSE(fitsAt(0.397, 1.0));
    EXPECT_TRUE(fitsAt(0.4, 1.0)) << "the line leaves through this half, too";
}

TEST(Unshadowed, IsTheLightOfTheCentreForEitherViewer) {
    ReplayCase made = replayOf({open});
    PointLog& point = made.log.points[0];
    const ColourRGB here = unshadowed(point, made.log.scene(), 0, false);
    EXPECT_NEAR(here.r, kFull.r, 1e-9);
    EXPECT_NEAR(here.b, kFull.b, 1e-9);
    point.point.position = {1.0, 0.0, 2.0};
    point.point.viewer = {1.0, 3.0, 0.0};
    const Vector3 towards = (Vector3{0.0, 4.0, 0.0} - point.point.position).normalised();
    for (const bool viewerIsEye : {false, true}) {
        const Vector3 viewer = viewerIsEye ? Vector3{} : point.point.viewer;
        const PhongTerms terms = phongTerms(
            made.log.scene().planes[0].material, made.log.scene().pointLights[0], {0.0, 1.0, 0.0},
            (viewer - point.point.position).normalised(), towards, std::sqrt(21.0));
        const ColourRGB seen = unshadowed(point, made.log.scene(), 0, viewerIsEye);
        EXPECT_NEAR(seen.g, terms.diffuse.g + terms.specular.g, 1e-9);
    }
}

TEST(Tolerance, GrowsWithTheBiasOverTheNearestDistance) {
    ReplayCase made = replayOf({open});
    PointLog& point = made.log.points[0];
    const auto tolerance = [&] { return toleranceAt(point, made.log.scene(), false).r; };
    const double most = kAmbient.r + kFull.r;
    EXPECT_NEAR(tolerance(), most * (48.0 * 1e-4 / 3.0 + 2e-5) + 1e-9, 1e-9) << "to the viewer";
    point.point.viewer = {0.0, 5.0, 0.0};
    EXPECT_NEAR(tolerance(), most * (48.0 * 1e-4 / 4.0 + 2e-5) + 1e-9, 1e-9) << "to the light";
    point.lines[0][0].origin = {0.0, 0.01, 0.0};
    EXPECT_NEAR(tolerance(), most * (48.0 * 2e-3 / 4.0 + 2e-5) + 1e-9, 1e-9) << "at most";
    point.lines[0][0].origin = point.point.position;
    EXPECT_NEAR(tolerance(), most * (48.0 * 1e-4 / 4.0 + 2e-5) + 1e-9, 1e-9) << "at least";
    point.lines[0].clear();
    EXPECT_NEAR(tolerance(), most * 2e-5 + 1e-9, 1e-12);
}

}  // namespace
}  // namespace ticker::tasks
