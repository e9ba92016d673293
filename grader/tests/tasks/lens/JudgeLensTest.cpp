// T2.2 judged from logs made by hand.
#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/answers/LensPlots.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/lens/LensByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace ticker::tasks {
namespace {

/// A right render of 4 x 2 pixels.
struct RightLog : LensByHand {
    explicit RightLog(double amount = 0.2, int rays = 50) {
        asked.settings.width = 4;
        asked.settings.height = 2;
        Draw draw{6, 1};
        for (int i = 0; i < 8; ++i) {
            const int row = i / 4;
            LensPixel& made = pixel({0.1 * (i % 4), 0.2 * row, 1.0});
            for (int ray = 0; ray < rays; ++ray) {
                const double x = draw.between(-amount, amount);
                made.rays.push_back(rayThrough({x, draw.between(-amount, amount), 0.0},
                                               focalPointOf(made, asked.settings)));
                made.rays.back().value = ColourRGB{0.1 * i + 0.1, 0.3, 0.2};
                made.rays.back().bounces = asked.settings.bounces;
            }
            made.colour = {0.1 * i + 0.1, 0.3, 0.2};
        }
    }
};

LensOutcome judge(const LensByHand& handout) {
    const RightLog other;
    return judgeDepthOfField(handout.log, other.log);
}

std::string idsOf(const LensOutcome& outcome) {
    std::string ids;
    for (const Finding& finding : outcome.findings)
        ids += finding.id + " ";
    return ids;
}

TEST(JudgeDepthOfField, AcceptsARightLogAndShowsItsPlots) {
    const LensOutcome outcome = judge(RightLog());
    EXPECT_EQ(idsOf(outcome), "");
    EXPECT_EQ(outcome.apertureFactor, 1.0);
    EXPECT_EQ(outcome.plots.size(), 2U);
    EXPECT_FALSE(outcome.rayless);
    EXPECT_FALSE(outcome.valueless);
    EXPECT_EQ(judge(RightLog(0.1)).apertureFactor, 0.5);
}

TEST(JudgeDepthOfField, FindsPixelsThatWereNotSet) {
    RightLog unset;
    for (const std::size_t i : {6U, 7U}) {
        unset.log.pixels[i].rays.clear();
        unset.log.pixels[i].colour = {};
    }
    const LensOutcome outcome = judge(unset);
    ASSERT_EQ(idsOf(outcome), "dof.wrong ");
    EXPECT_NE(outcome.findings[0].message.find("2 of 8 have no ray and stay black"),
              std::string::npos);
    EXPECT_NE(outcome.findings[0].message.find("column 2, row 1"), std::string::npos);
}

TEST(JudgeDepthOfField, JudgesNoRaysWhereSomeCannotBeSeen) {
    RightLog hidden;
    hidden.log.pixels[3].rays.clear();
    EXPECT_TRUE(judge(hidden).rayless) << "set, but by unknown code";
    EXPECT_EQ(idsOf(judge(hidden)), "");
    RightLog black;
    black.log.pixels[3].colour = {};
    ASSERT_EQ(judge(black).findings.size(), 1U);
    EXPECT_EQ(judge(black).findings[0].message.find("stay black"), std::string::npos)
        << "it has rays";
    for (LensPixel& pixel : black.log.pixels)
        pixel.rays.clear();
    EXPECT_TRUE(judge(black).rayless);
    EXPECT_EQ(idsOf(judge(black)), "") << "black, but no ray was seen anywhere";
    RightLog valueless;
    for (LensPixel& pixel : valueless.log.pixels)
        for (LensRay& ray : pixel.rays)
            ray.value.reset();
    EXPECT_TRUE(judge(valueless).valueless);
}

TEST(JudgeDepthOfField, TellsPixelsThatCopyANeighbour) {
    RightLog copied;
    for (const std::size_t odd : {1U, 3U, 5U, 7U}) {
        LensPixel& source = copied.log.pixels[odd - 1];
        source.rays[7].value = ColourRGB{0.7, 0.1, 0.9};
        source.colour += ColourRGB{0.001, 0.002, 0.003};
        copied.log.pixels[odd].rays.clear();
        copied.log.pixels[odd].colour = source.colour;
    }
    const LensOutcome outcome = judge(copied);
    ASSERT_EQ(idsOf(outcome), "dof.too-few-rays ");
    EXPECT_FALSE(outcome.rayless) << "nothing is left to pictures";
    const Finding& finding = outcome.findings[0];
    EXPECT_NE(
        finding.message.find("4 of 8 pixels, the first in column 1, row 0, have none and show "
                             "the colour of a neighbour"),
        std::string::npos)
        << finding.message;
    EXPECT_NE(finding.hint.find("copies"), std::string::npos);
    copied.log.pixels[5].colour.g += 1e-9;
    EXPECT_TRUE(judge(copied).rayless) << "one may be computed by unseen code";
    EXPECT_TRUE(judge(copied).partly);
    for (LensPixel& pixel : copied.log.pixels)
        pixel.rays.clear();
    EXPECT_FALSE(judge(copied).partly);
}

TEST(JudgeDepthOfField, TakesNoEvenColourForACopy) {
    RightLog even;
    even.log.pixels[2].colour = even.log.pixels[1].colour;
    even.log.pixels[2].rays.clear();
    EXPECT_TRUE(judge(even).rayless) << "all rays may have met the same floor";
    EXPECT_EQ(idsOf(judge(even)), "");
}

TEST(JudgeDepthOfField, WantsNumbersInEveryChannel) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const ColourRGB& odd :
         {ColourRGB{nan, 0.0, 0.0}, ColourRGB{0.0, nan, 0.0}, ColourRGB{0.0, 0.0, nan}}) {
        RightLog made;
        made.log.pixels[5].colour = odd;
        EXPECT_EQ(idsOf(judge(made)), "dof.wrong ");
    }
}

TEST(JudgeDepthOfField, SaysNoMoreOfALensThatIsNone) {
    RightLog none;
    for (LensPixel& pixel : none.log.pixels)
        for (LensRay& ray : pixel.rays) {
            ray.origin = {};
            ray.direction = {0.3, 0.0, 0.9};
        }
    EXPECT_EQ(idsOf(judge(none)), "dof.none ");
    RightLog shared;
    for (LensPixel& pixel : shared.log.pixels)
        for (LensRay& ray : pixel.rays)
            ray = pixel.rays.front();
    EXPECT_EQ(idsOf(judge(shared)), "dof.shared-samples ");
}

TEST(JudgeDepthOfField, WarnsOfOtherSettingsThatAreNotFollowed) {
    const RightLog right;
    RightLog other;
    other.asked.settings.dofAmount = 0.3;
    const LensOutcome outcome = judgeDepthOfField(right.log, other.log);
    ASSERT_EQ(idsOf(outcome), "settings.hard-coded ");
    EXPECT_EQ(outcome.findings[0].severity, Severity::warn);
    RightLog wrong;
    wrong.asked.settings.dofAmount = 0.3;
    EXPECT_EQ(idsOf(judgeDepthOfField(wrong.log, other.log)), "dof.aperture-size ")
        << "what is wrong at the handout's settings is said once";
    other.log.pixels[1].rays.clear();
    EXPECT_EQ(idsOf(judgeDepthOfField(right.log, other.log)), "") << "nothing can be said";
}

TEST(JudgeDepthOfField, SaysThatMoreRaysThanTheHandoutsAreAccepted) {
    const RightLog right;
    const auto messageWith = [&](int rays) {
        RightLog other{0.2, rays};
        other.asked.settings.dofRayCount = 80;
        const LensOutcome outcome = judgeDepthOfField(right.log, other.log);
        return outcome.findings.empty() ? std::string{} : outcome.findings[0].message;
    };
    EXPECT_NE(messageWith(60).find("The handout says 50 rays; more are accepted."),
              std::string::npos);
    EXPECT_NE(messageWith(50), "");
    EXPECT_EQ(messageWith(50).find("more are accepted"), std::string::npos);
    EXPECT_EQ(messageWith(80), "");
}

TEST(JudgeDepthOfField, FailsFewerRaysThanTheHandoutsInAPictureWithOtherSettings) {
    RightLog other{0.2, 80};
    other.asked.settings.dofRayCount = 80;
    std::vector<LensRay>& rays = other.log.pixels[1].rays;
    rays.resize(1);
    other.log.pixels[1].colour = *rays[0].value;
    const LensOutcome outcome = judgeDepthOfField(RightLog().log, other.log);
    ASSERT_EQ(idsOf(outcome), "dof.too-few-rays ");
    EXPECT_NE(outcome.findings[0].message.find("with other settings it is not"), std::string::npos);
    other.log.cut = true;
    EXPECT_EQ(idsOf(judgeDepthOfField(RightLog().log, other.log)), "settings.hard-coded ");
}

TEST(JudgeDepthOfField, WarnsOfPixelsThatAreLostInAPictureOfAnotherSize) {
    RightLog other;
    for (LensPixel& pixel : other.log.pixels) {
        pixel.rays.clear();
        pixel.colour = {};
    }
    const LensOutcome outcome = judgeDepthOfField(RightLog().log, other.log);
    ASSERT_EQ(idsOf(outcome), "settings.hard-coded ");
    EXPECT_NE(outcome.findings[0].message.find("8 of 8 have no ray"), std::string::npos);
}

std::optional<Finding> judgeOdd(int rays, double colourTimes = 1.0) {
    RightLog log{0.2, rays};
    log.asked.settings.dofRayCount = 43;
    for (LensPixel& pixel : log.log.pixels)
        pixel.colour = pixel.colour * colourTimes;
    return judgeOddCount(log.log);
}

TEST(JudgeOddCount, WantsAsManyRaysOrMoreAndTheirMean) {
    EXPECT_FALSE(judgeOdd(43));
    EXPECT_FALSE(judgeOdd(44));
    EXPECT_FALSE(judgeOdd(49));
    const auto lost = judgeOdd(42);
    ASSERT_EQ(idOf(lost), "dof.too-few-rays");
    EXPECT_NE(lost->message.find("with an odd number it is not. 43 rays"), std::string::npos)
        << lost->message;
    EXPECT_NE(lost->hint.find("in pairs"), std::string::npos);
    EXPECT_EQ(idOf(judgeOdd(44, 44.0 / 43.0)), "dof.not-averaged");
    EXPECT_FALSE(judgeOdd(50, 50.0 / 43.0)) << "the handout's number, typed in";
    EXPECT_FALSE(judgeOdd(43, 43.0 / 50.0)) << "divided by the handout's number";
}

TEST(JudgeWithThreads, NamesWhatOnlySeveralThreadsDo) {
    RightLog log;
    EXPECT_FALSE(judgeWithThreads(log.log));
    log.log.pixels[2].colour = {0.1, 0.2, 0.3};
    const std::optional<Finding> finding = judgeWithThreads(log.log);
    ASSERT_TRUE(finding);
    EXPECT_EQ(finding->id, "dof.threads-mixed");
    EXPECT_EQ(finding->severity, Severity::fail);
    EXPECT_NE(finding->message.find("mean of its rays' colours"), std::string::npos);
}

TEST(Plots, ShowWhereRaysStartAndCross) {
    LensByHand lens;
    LensPixel& pixel = lens.pixel({0.3, 0.0, 1.0});
    const Vector3 focal = focalPointOf(pixel, lens.asked.settings);
    pixel.rays = {rayThrough({0.1, -0.2, 0.0}, focal + Vector3{0.05, 0.02, 0.0}),
                  rayThrough({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0})};
    const ScatterPlot starts = plotLens(lens.log);
    ASSERT_EQ(starts.points.size(), 2U);
    EXPECT_NEAR(starts.points[0].y, -0.2, 1e-12);
    EXPECT_EQ(starts.expectedHalfWidth, 0.2);
    EXPECT_EQ(starts.otherHalfWidth, 0.1);
    EXPECT_TRUE(starts.drawing.has_value() || plotFocus(lens.log).drawing.has_value());
    const ScatterPlot crossings = plotFocus(lens.log);
    ASSERT_EQ(crossings.points.size(), 1U) << "the other never does";
    EXPECT_NEAR(crossings.points[0].x, 0.05, 1e-9);
    EXPECT_NEAR(crossings.points[0].y, 0.02, 1e-9);
    EXPECT_NEAR(crossings.expectedHalfWidth, 3.51805 * 0.41421356 / 640.0, 1e-7);
}

TEST(Plots, HaveSomeFiveHundredPointsAtMost) {
    const auto points = [](int rays) {
        LensByHand lens;
        LensPixel& pixel = lens.pixel();
        for (int i = 0; i < rays; ++i)
            pixel.rays.push_back(rayThrough({0.001 * i, 0.0, 0.0}, {0.0, 0.0, 1.0}));
        return plotLens(lens.log).points;
    };
    EXPECT_EQ(points(500).size(), 500U);
    EXPECT_EQ(points(501).size(), 251U);
    EXPECT_EQ(points(1000).size(), 500U);
    ASSERT_EQ(points(1001).size(), 334U);
    EXPECT_NEAR(points(1001)[333].x, 0.999, 1e-12) << "every third";
}

}  // namespace
}  // namespace ticker::tasks
