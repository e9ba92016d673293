#include <grader/tasks/drawings/DrawBumps.h>

#include <grader/tasks/drawings/LetterEdges.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace ticker::tests {
namespace {

using selftest::Mistake;
using selftest::Reading;
using tasks::drawings::edgesOf;
using tasks::drawings::LetterEdge;

/// The drawing that a failing reading gets; empty: none.
std::optional<RayDrawing> drawnOf(const Reading& reading, Mistake mistake) {
    selftest::FunctionExaminee examinee(
        [=](const Point& point) { return modelNormal(reading, mistake, point); });
    TaskJudgement judgement = tasks::judgeBump(examinee, 5);
    tasks::drawBumps(examinee, judgement);
    if (judgement.findings.empty()) return std::nullopt;
    const std::vector<ScatterPlot>& plots = judgement.findings.front().plots;
    return plots.empty() ? std::nullopt : plots.back().drawing;
}

double dot(const RayDrawing::Point& a, const RayDrawing::Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TEST(LetterEdges, AreTheStraightEdgesOfTheLetters) {
    const std::vector<LetterEdge> h = edgesOf(0, 0);
    const std::vector<LetterEdge> l = edgesOf(1, 0);
    EXPECT_EQ(h.size(), 12U);
    EXPECT_EQ(l.size(), 6U);
    const auto leftOf = [](const std::vector<LetterEdge>& edges) {
        return *std::ranges::min_element(
            edges, {}, [](const LetterEdge& edge) { return edge.isUpright ? edge.from.x : 1e9; });
    };
    EXPECT_EQ(leftOf(h).length(), 60.0);
    EXPECT_EQ(leftOf(h).rise, 1.0) << "an H is brighter than its ground";
    EXPECT_EQ(leftOf(l).rise, -1.0) << "an L is darker";
}

TEST(DrawBumps, TheGivenNormalsAreOnTheWrongSideOfTheInvertedAxisAlone) {
    const auto drawing = drawnOf({}, Mistake::invertedU);
    ASSERT_TRUE(drawing);
    ASSERT_EQ(drawing->words.size(), 3U);
    EXPECT_NE(drawing->words[1].find("(along u), 0 of 13 normals lean away"), std::string::npos)
        << drawing->words[1];
    EXPECT_NE(drawing->words[2].find("(along v), 10 of 10 normals lean away"), std::string::npos)
        << drawing->words[2];
    int opposite = 0;
    for (const RayDrawing::Normal& normal : drawing->normals) {
        const double between = dot(*normal.expected, normal.given);
        const double half = dot(*normal.expected, normal.smooth);
        if (between < half * half + 1e-3 && between < 0.99) ++opposite;
        EXPECT_NEAR(dot(normal.given, normal.given), 1.0, 1e-9);
        EXPECT_LT(normal.at[2], 3.5) << "on the side that the camera sees";
    }
    EXPECT_EQ(opposite, 13);
    EXPECT_EQ(drawing->outlines.size(), 18U);
}

TEST(DrawBumps, ExpectedNormalsAreTheGivenOnesWhereOnlyTheLengthIsWrong) {
    for (const Reading& reading :
         {Reading{}, Reading{.uOrigin = 0.1, .mirrored = true}, Reading{.top = Reading::Top::x},
          Reading{.gain = Reading::Gain::sine, .strength = 3.0}}) {
        const auto drawing = drawnOf(reading, Mistake::notUnit);
        ASSERT_TRUE(drawing);
        EXPECT_GE(drawing->normals.size(), 20U);
        for (const RayDrawing::Normal& normal : drawing->normals)
            EXPECT_GT(dot(*normal.expected, normal.given), 0.95);
    }
}

TEST(DrawBumps, NothingIsDrawnOfARightReadingNorWhereNoMapIsSeen) {
    EXPECT_FALSE(drawnOf({}, Mistake::none));
    selftest::FunctionExaminee examinee(smooth);
    TaskJudgement judgement = tasks::judgeBump(examinee, 5);
    tasks::drawBumps(examinee, judgement);
    EXPECT_TRUE(judgement.findings.front().plots.empty());
}

}  // namespace
}  // namespace ticker::tests
