// Slopes beside the first and last texels of small maps.
#include <grader/tasks/bump/places/FewTexels.h>
#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using selftest::Point;

FewTexels fewTexelsOf(const selftest::NormalFunction& function,
                      const Parametrisation& parametrisation = tests::kParametrisation,
                      std::uint64_t seed = 4) {
    Questionnaire questionnaire;
    Draws draws(seed);
    const FewTexelPlan plan = planFewTexels(questionnaire, draws, {{0.5, -1.0, 20.0}, 12.0});
    return readFewTexels(plan, tests::answersOf(questionnaire, function), parametrisation);
}

/// Right, but for factors of the slopes.
selftest::NormalFunction withFactors(
    std::function<std::pair<double, double>(const tests::Place&, const Point&)> factors) {
    return tests::inProportion(tests::kParametrisation, std::move(factors));
}

TEST(ReadFewTexels, SeesALostOrInvertedSlopeInOneRowOrColumnBesideTheEdge) {
    const auto isSecond = [](int texel, int count, bool fromEnd) {
        return texel == (fromEnd ? count - 2 : 1);
    };
    for (const double factor : {0.0, -1.0})
        for (const bool fromEnd : {false, true}) {
            const FewTexels rows =
                fewTexelsOf(withFactors([=](const tests::Place& at, const Point& point) {
                    const bool wrong = isSecond(at.row, point.map.height(), fromEnd);
                    return std::pair{1.0, wrong ? factor : 1.0};
                }));
            EXPECT_TRUE(rows.goodU());
            EXPECT_EQ(rows.alongV, 0.0);
            const FewTexels columns =
                fewTexelsOf(withFactors([=](const tests::Place& at, const Point& point) {
                    const bool wrong = isSecond(at.column, point.map.width(), fromEnd);
                    return std::pair{wrong ? factor : 1.0, 1.0};
                }));
            EXPECT_EQ(columns.alongU, 0.0);
            EXPECT_TRUE(columns.goodV());
        }
}

TEST(ReadFewTexels, SaysNothingAboutTheFirstAndTheLastTexel) {
    EXPECT_TRUE(fewTexelsOf(withFactors([](const tests::Place& at, const Point& point) {
                    const bool isEdge = at.row == 0 || at.row == point.map.height() - 1;
                    return std::pair{1.0, isEdge ? 0.0 : 1.0};
                })).good());
}

/// Differences to the next column and row, which wrap as on a map with so many columns or rows
/// less.
/// @param step  -1: to the previous column and row.
selftest::NormalFunction wrapping(int columnsLess, int rowsLess, int step = 1) {
    return [=](const Point& point) {
        const Vector3 n = tests::smooth(point);
        const Parametrisation& sphere = tests::kParametrisation;
        const auto texel = [](double coordinate, int count) {
            return std::clamp(static_cast<int>(coordinate * count), 0, count - 1);
        };
        const int width = point.map.width();
        const int height = point.map.height();
        const int column = texel(sphere.u(n), width);
        const int row = texel(sphere.v(n), height);
        const auto neighbour = [step](int at, int count) { return (at + step + count) % count; };
        const double here = point.map.at(column, row);
        const double slopeU = point.map.at(neighbour(column, width - columnsLess), row) - here;
        const double slopeV = point.map.at(column, neighbour(row, height - rowsLess)) - here;
        return (n - (sphere.alongU(n) * slopeU + sphere.alongV(n) * slopeV) * step).normalised();
    };
}

TEST(ReadFewTexels, SeesANeighbourThatWrapsOneTexelTooEarly) {
    const FewTexels right = fewTexelsOf(wrapping(0, 0));
    EXPECT_NEAR(right.beforeLastColumn, 1.0, 0.2);
    EXPECT_NEAR(right.beforeLastRow, 1.0, 0.2);
    const FewTexels columns = fewTexelsOf(wrapping(1, 0));
    EXPECT_EQ(columns.beforeLastColumn, 0.0);
    EXPECT_TRUE(columns.goodV());
    const FewTexels rows = fewTexelsOf(wrapping(0, 1));
    EXPECT_EQ(rows.beforeLastRow, 0.0);
    EXPECT_TRUE(rows.goodU());
    EXPECT_TRUE(fewTexelsOf(wrapping(0, 0, -1)).good());
}

/// Right, but at the outer half of the first or the last column it has the slope of a column on the
/// flank.
selftest::NormalFunction farColumnAtSeam(bool fromEnd) {
    return withFactors([=](const tests::Place& at, const Point& point) {
        const int width = point.map.width();
        const double fromSeam = (fromEnd ? 1.0 - at.u : at.u) * width;
        const int flank = width / 4;
        const double steep = point.map.at(flank + 1, at.row) - point.map.at(flank, at.row);
        const bool isFar = fromSeam < 0.5 && at.alongU != 0.0;
        return std::pair{isFar ? steep / at.alongU : 1.0, 1.0};
    });
}

TEST(ReadFewTexels, SeesTheSlopeOfAFarColumnAtTheSeam) {
    EXPECT_EQ(fewTexelsOf(wrapping(0, 0)).steepAtSeam, 0.0);
    for (const bool fromEnd : {false, true}) {
        const FewTexels far = fewTexelsOf(farColumnAtSeam(fromEnd));
        EXPECT_EQ(far.steepAtSeam, 1.0) << fromEnd;
        EXPECT_FALSE(far.good());
    }
}

TEST(JudgeBump, SaysThatTheSlopeAtTheSeamIsThatOfAFarColumn) {
    const TaskJudgement judgement = tests::judge(farColumnAtSeam(false));
    ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("a column far away"), std::string::npos) << judgement.reason;
}

TEST(JudgeBump, SaysThatTheLastColumnIsNoNeighbour) {
    const TaskJudgement judgement = tests::judge(wrapping(1, 0));
    ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("higher last column"), std::string::npos) << judgement.reason;
}

TEST(JudgeBump, SaysThatTheSlopeBesideTheLastRowIsLost) {
    const TaskJudgement judgement =
        tests::judge(withFactors([](const tests::Place& at, const Point& point) {
            return std::pair{1.0, at.row == point.map.height() - 2 ? 0.0 : 1.0};
        }));
    ASSERT_EQ(tests::firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("in the row beside the first or the last one"),
              std::string::npos)
        << judgement.reason;
}

}  // namespace
}  // namespace ticker::tasks::bump
