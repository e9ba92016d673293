// The judgement of points that see a part of the light, by values alone.
#include <grader/tasks/shadows/penumbra/PenumbraCheck.h>
#include <grader/tasks/shadows/penumbra/PenumbraHits.h>
#include <grader/tasks/shadows/penumbra/PenumbraShares.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace ticker::tasks {
namespace {

using Kind = PenumbraQuestion::Place::Kind;

const PenumbraQuestion& question() {
    static const PenumbraQuestion drawn = drawPenumbraQuestion(5);
    return drawn;
}

/// The share of the light that one call gives, from the share of the light that is visible.
using ShareOf = std::function<double(double open, Draw& draw)>;

struct Answer {
    double size = 1.0;               ///< of the light
    double beyond = 0.0;             ///< share at places that should see nothing
    bool beyondAlways = false;       ///< `beyond` in every call instead of the first
    double within = 0.1;             ///< share in the first call where the outermost part is seen
    bool darkRim = false;            ///< no light at places that should see the outermost twentieth
    raytracer::ColourRGB more{0.0};  ///< added to every colour
    AimShape shape = AimShape::ball;
    std::size_t phong = 0;  ///< reading of ExpectedShares
    bool viewerIsEye = false;
};

/// The share that a call gives, if its place sees the share `seen`.
double shareGiven(Kind kind, bool isFirstCall, double seen, const Answer& how) {
    switch (kind) {
        case Kind::penumbra:
            return seen;
        case Kind::atRim:
            return how.darkRim ? 0.0 : seen;
        case Kind::beyondRim:
            return isFirstCall || how.beyondAlways ? how.beyond : seen;
        case Kind::withinRim:
            return isFirstCall ? how.within : seen;
    }
    return seen;
}

PenumbraVerdict judge(const ShareOf& shareOf, const Answer& how = {},
                      const PenumbraQuestion& question = tasks::question()) {
    const probe::IlluminateQuestion& asked = question.question;
    const Surfaces surfaces{asked.scene};
    probe::IlluminateAnswer answer;
    answer.state = probe::AnswerState::answered;
    Draw draw{8, 9};
    for (const PenumbraQuestion::Place& place : question.places) {
        PointLog log;
        log.point = asked.points[place.first];
        log.lines.resize(1);
        const ColourRGB full = unshadowed(log, asked.scene, 0, false);
        const ExpectedShares expected = expectedAt(asked, surfaces, log.point, how.shape, how.size);
        const auto& sharesOfViewer = expected.share[how.viewerIsEye ? 1 : 0];
        const double phongFactor =
            expected.open > 0.0 ? sharesOfViewer[how.phong] / expected.open : 1.0;
        const bool seesLight =
            place.kind == Kind::penumbra || place.kind == Kind::atRim || how.size > 1.0;
        for (std::size_t i = 0; i < place.calls; ++i) {
            const double seen = seesLight ? shareOf(expected.open, draw) * phongFactor : 0.0;
            const double share = shareGiven(place.kind, i == 0, seen, how);
            answer.colours.push_back(ambientPart(log, asked.scene) + full * share + how.more);
        }
    }
    PenumbraExpectations expectations{question};
    return checkPenumbra(expectations, answer);
}

/// The share of this many rays that arrive.
ShareOf rays(int count) {
    return [count](double open, Draw& draw) {
        int arrive = 0;
        for (int i = 0; i < count; ++i)
            arrive += draw.between(0.0, 1.0) < open ? 1 : 0;
        return arrive / static_cast<double>(count);
    };
}

// Each right answer is refused with a chance below 1e-9.
TEST(CheckPenumbra, AcceptsTenRays) {
    const PenumbraVerdict verdict = judge(rays(10));
    EXPECT_FALSE(verdict.finding);
    EXPECT_FALSE(verdict.ambiguous);
    EXPECT_LT(verdict.timesTheBound, 1.0);
    EXPECT_GT(verdict.timesTheBound, 0.01);
}

TEST(CheckPenumbra, AcceptsEveryShapeAndNoneOfThemATenthSmaller) {
    for (const AimShape shape : kAcceptedAimShapes) {
        const PenumbraVerdict verdict = judge(rays(10), {.shape = shape});
        EXPECT_FALSE(verdict.finding || verdict.ambiguous);
        EXPECT_LT(verdict.timesTheBound, 1.0);
        const PenumbraVerdict smaller = judge(rays(10), {.size = 0.9, .shape = shape});
        EXPECT_TRUE(smaller.finding || smaller.ambiguous);
    }
}

TEST(CheckPenumbra, AcceptsEveryPhongReadingWithEveryFalloffAndWarnsOfTheNearSides) {
    for (std::size_t phong = 0; phong < ExpectedShares::kPhongReadings; ++phong)
        for (const AimShape shape : {AimShape::ball, AimShape::surface, AimShape::flatDisc})
            for (const bool viewerIsEye : {false, true}) {
                const PenumbraVerdict verdict =
                    judge(rays(10), {.shape = shape, .phong = phong, .viewerIsEye = viewerIsEye});
                const bool nearSide = ExpectedShares::isNearSide(phong);
                EXPECT_EQ(idOf(verdict.finding), nearSide ? "shadow.near-side-falloff" : "")
                    << phong << ' ' << viewerIsEye;
                EXPECT_FALSE(verdict.ambiguous);
                if (verdict.finding) {
                    EXPECT_EQ(verdict.finding->severity, Severity::warn);
                }
            }
}

TEST(CheckPenumbra, NamesTheSizeOfALightThatIsTooSmallOrTooLarge) {
    for (const double size : {0.5, 0.75, 1.25, 1.5}) {
        const PenumbraVerdict verdict = judge(rays(10), {.size = size});
        ASSERT_EQ(idOf(verdict.finding), "shadow.light-size") << size;
        EXPECT_NEAR(numberIn(*verdict.finding, "radius"), 0.4 * size, 0.05);
        EXPECT_GT(verdict.timesTheBound, 1.0);
    }
}

// At more than twice the bound an error of a tenth is missed with a chance far below 1e-9.
TEST(CheckPenumbra, FindsALightThatIsATenthTooSmallOrTooLargeWhateverIsDrawn) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const PenumbraQuestion drawn = drawPenumbraQuestion(seed);
        for (const double size : {0.9, 1.1}) {
            const PenumbraVerdict verdict = judge(rays(10), {.size = size}, drawn);
            EXPECT_EQ(idOf(verdict.finding), "shadow.light-size") << seed << ' ' << size;
            EXPECT_GT(verdict.timesTheBound, 2.0) << seed << ' ' << size;
        }
    }
}

TEST(CheckPenumbra, FindsLightBeyondTheRimAndNoneWithinIt) {
    EXPECT_TRUE(judge(rays(10), {.beyond = 0.1}).finding);
    EXPECT_FALSE(judge(rays(10), {.beyond = 0.015}).finding);
    EXPECT_TRUE(judge(rays(10), {.within = 0.0}).finding);
    EXPECT_FALSE(judge(rays(10), {.within = 0.025}).finding);
}

TEST(CheckPenumbra, TellsLightThatIsLeftInShadowFromALargerLight) {
    const PenumbraVerdict once = judge(rays(10), {.beyond = 0.1});
    ASSERT_TRUE(once.finding);
    EXPECT_EQ(once.finding->message.find("ambient light alone"), std::string::npos);
    const PenumbraVerdict always = judge(rays(10), {.beyond = 0.1, .beyondAlways = true});
    ASSERT_EQ(idOf(always.finding), "shadow.wrong");
    EXPECT_NEAR(numberIn(*always.finding, "leftInShadow"), 0.1, 1e-9);
}

TEST(CheckPenumbra, CountsTheRaysByTheSteps) {
    EXPECT_EQ(idOf(judge(rays(1)).finding), "shadow.hard");
    for (const int count : {2, 5, 9}) {
        const PenumbraVerdict verdict = judge(rays(count));
        ASSERT_EQ(idOf(verdict.finding), "shadow.too-few-rays") << count;
        EXPECT_NE(verdict.finding->message.find("1/" + std::to_string(count)), std::string::npos);
        EXPECT_EQ(verdict.finding->message.find("10 shadow rays were expected"), 0U);
    }
    EXPECT_FALSE(judge(rays(11)).finding) << "an extra ray";
}

TEST(CheckPenumbra, NamesTheNumberOfRaysThatItAsksFor) {
    PenumbraQuestion more = question();
    more.question.settings.shadowRayCount = 14;
    const auto twelve = [](double open, Draw& draw) {
        int hits = 0;
        for (int ray = 0; ray < 12; ++ray)
            if (draw.between(0.0, 1.0) < open) ++hits;
        return hits / 12.0;
    };
    const PenumbraVerdict verdict = judge(twelve, {}, more);
    ASSERT_EQ(idOf(verdict.finding), "shadow.too-few-rays");
    EXPECT_EQ(verdict.finding->message.find("14 shadow rays were expected"), 0U);
}

/// The question with fewer places in the penumbra: those that see a share of the light between
/// `low` and `high`. The others become places at the rim.
PenumbraQuestion withShares(double low, double high) {
    PenumbraQuestion some = question();
    const Surfaces surfaces{some.question.scene};
    for (PenumbraQuestion::Place& place : some.places) {
        const probe::LitPoint& point = some.question.points[place.first];
        const double open = expectedAt(some.question, surfaces, point, AimShape::ball, 1.0).open;
        if (place.kind == Kind::penumbra && (open <= low || open >= high)) place.kind = Kind::atRim;
    }
    return some;
}

// One ray gives 0 or 1. That says something only where a fraction is expected.
TEST(CheckPenumbra, CountsRaysWhereAFractionIsExpected) {
    EXPECT_EQ(idOf(judge(rays(1), {}, withShares(0.1, 0.9)).finding), "shadow.hard");
    EXPECT_NE(idOf(judge(rays(1), {}, withShares(-1.0, 0.1)).finding), "shadow.hard");
}

TEST(CheckPenumbra, TellsAllOrNothingFromOneRay) {
    const ShareOf ifAll = [](double open, Draw& draw) {
        return rays(10)(open, draw) == 1.0 ? 1.0 : 0.0;
    };
    EXPECT_EQ(idOf(judge(ifAll).finding), "shadow.all-or-nothing");
    const ShareOf still = [](double open, Draw&) { return open > 0.5 ? 1.0 : 0.0; };
    EXPECT_EQ(idOf(judge(still).finding), "shadow.hard");
}

TEST(CheckPenumbra, LeavesCallsThatAreAllTheSameToAPerson) {
    const PenumbraVerdict verdict = judge([](double open, Draw&) { return 0.9 * open; });
    EXPECT_FALSE(verdict.finding);
    EXPECT_TRUE(verdict.ambiguous);
}

TEST(CheckPenumbra, LeavesALightWithoutItsOutermostTwentiethToAPerson) {
    const PenumbraVerdict verdict = judge(rays(10), {.darkRim = true});
    EXPECT_FALSE(verdict.finding);
    EXPECT_TRUE(verdict.ambiguous);
}

TEST(CheckPenumbra, NamesNoSizeWhereNoneExplainsTheMeans) {
    const ShareOf dimmed = [](double open, Draw& draw) { return rays(10)(0.6 * open, draw); };
    const PenumbraVerdict verdict = judge(dimmed, {}, withShares(0.6, 0.95));
    ASSERT_EQ(idOf(verdict.finding), "shadow.wrong");
    EXPECT_NE(verdict.finding->message.find("wrong size or shape"), std::string::npos);
}

TEST(CheckPenumbra, WantsNumbers) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(idOf(judge(rays(10), {.more = ColourRGB{nan}}).finding), "shadow.wrong");
}

}  // namespace
}  // namespace ticker::tasks
