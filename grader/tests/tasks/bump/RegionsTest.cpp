#include <grader/tests/tasks/bump/Asked.h>
#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

// Properties of the questions: rows and columns of large maps, greys, spheres behind the eye.
namespace ticker::tests {
namespace {

using selftest::FunctionExaminee;
using selftest::HeightMap;
using selftest::Mistake;
using selftest::modelNormal;
using selftest::Reading;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Place of a point on the map, 0 to 1: down, and to the right.
double down(const Point& point) {
    return std::acos(std::clamp(smooth(point).y, -1.0, 1.0)) / std::numbers::pi;
}
double along(const Point& point) {
    const Vector3 n = smooth(point);
    return 0.5 + std::atan2(n.x, -n.z) / (2.0 * std::numbers::pi);
}

/// Inverted along u where `isWrong` is true, right elsewhere.
template <typename IsWrong>
TaskJudgement judgeInvertedWhere(IsWrong isWrong) {
    return judge([=](const Point& point) {
        return modelNormal({}, isWrong(point) ? Mistake::invertedU : Mistake::none, point);
    });
}

TEST(BumpRegions, NameTheRowsInWhichALargeMapDiffers) {
    const TaskJudgement judgement = judge({}, Mistake::lowRows);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.reason, "along u")) << judgement.reason;
    EXPECT_TRUE(contains(judgement.reason, "mostly in rows")) << judgement.reason;
    EXPECT_FALSE(contains(judgement.reason, "columns")) << judgement.reason;
    EXPECT_FALSE(contains(judgement.reason, "along v")) << judgement.reason;
}

TEST(BumpRegions, ShowAPatchOfALargeMapThatIsAnEighteenthOfTheSphere) {
    const TaskJudgement judgement = judgeInvertedWhere([](const Point& point) {
        return point.map.width() > 500 && point.map.height() > 500 && along(point) > 0.5 &&
               along(point) < 0.75 && down(point) > 0.5 && down(point) < 0.65;
    });
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(firstId(judgement), "bump.wrong");
}

TEST(BumpRegions, NameNoSignThatIsWrongInSomeRowsOrGreysAlone) {
    const TaskJudgement rows = judgeInvertedWhere(
        [](const Point& point) { return down(point) * point.map.height() < 300.0; });
    EXPECT_EQ(firstId(rows), "bump.wrong");
    EXPECT_EQ(firstId(judge({}, Mistake::darkHalf)), "bump.wrong");
}

TEST(BumpRegions, LieBehindTheEyeAsWellAsInFront) {
    const TaskJudgement judgement =
        judgeInvertedWhere([](const Point& point) { return point.centre.z < 0.0; });
    EXPECT_EQ(judgement.state, TaskState::failed);
}

TEST(BumpHeights, MayBeRoundedToBytesWhichASecondRunShows) {
    Reading reading;
    reading.heights = Reading::Heights::rounded;
    FunctionExaminee examinee(
        [&](const Point& point) { return modelNormal(reading, Mistake::none, point); });
    EXPECT_EQ(tasks::judgeBump(examinee, 5).state, TaskState::passed);
    EXPECT_EQ(examinee.runs(), 2);
    EXPECT_EQ(firstId(judge(reading, Mistake::invertedV)), "bump.inverted-v");
}

// 1 / (r + h) is weaker where the map is bright, as far as decision 0003 accepts it.
TEST(BumpHeights, MayBeRoundedWhereTheyDisplaceASurface) {
    for (const double strength : {4.0, 8.0, 20.0, 40.0}) {
        Reading reading;
        reading.heights = Reading::Heights::rounded;
        reading.gain = Reading::Gain::displacedUnit;
        reading.strength = strength;
        for (const std::uint64_t seed : {5U, 6U, 7U}) {
            const TaskJudgement judgement = judge(
                [&](const Point& point) { return modelNormal(reading, Mistake::none, point); },
                seed);
            EXPECT_EQ(judgement.state, TaskState::passed)
                << strength << ' ' << seed << ' ' << judgement.reason;
        }
    }
}

TEST(BumpHeights, AreNotRaisedToAPower) {
    EXPECT_EQ(firstId(judge({}, Mistake::powered)), "bump.wrong");
}

TEST(BumpHints, SayThatNormalsAreRounded) {
    const TaskJudgement judgement = judge([](const Point& point) {
        const auto tidy = [](double a) { return std::round(a * 10.0) / 10.0; };
        const Vector3 n = modelNormal({}, Mistake::none, point);
        return Vector3{tidy(n.x), tidy(n.y), tidy(n.z)}.normalised();
    });
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.reason, "rounded to few values")) << judgement.reason;
}

TEST(BumpHints, NameAStepOfManyTexels) {
    const TaskJudgement judgement = judge([](const Point& point) {
        constexpr double kStep = 0.03;
        const Vector3 n = smooth(point);
        const auto at = [&](double u, double v) {
            const int column = static_cast<int>((u - std::floor(u)) * point.map.width());
            const int row = static_cast<int>(std::min(v, 0.999) * point.map.height());
            return point.map.at(column, row);
        };
        const double u = kParametrisation.u(n);
        const double v = kParametrisation.v(n);
        return (n - (at(u + kStep, v) - at(u, v)) * kParametrisation.alongU(n) -
                (at(u, v + kStep) - at(u, v)) * kParametrisation.alongV(n))
            .normalised();
    });
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.findings.front().hint, "many texels")) << judgement.reason;
}

TEST(BumpHints, SayThatAMapIsRememberedNotThatTheSphereIsSmooth) {
    std::shared_ptr<const HeightMap> first;
    const TaskJudgement judgement = judge([&](const Point& point) {
        if (!first) first = std::make_shared<const HeightMap>(point.map);
        return modelNormal({}, Mistake::none, {*first, point.centre, point.radius, point.position});
    });
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.findings.front().hint, "static")) << judgement.reason;
}

TEST(BumpHints, TellASizeThatIsWrittenInBySmallerMaps) {
    const TaskJudgement judgement = judge({}, Mistake::rowsEnd);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.findings.front().hint, "written in")) << judgement.reason;
}

TEST(BumpHints, TellTheRowsThatAreNeverRead) {
    const TaskJudgement judgement = judge({}, Mistake::halfRows);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.reason, "last rows")) << judgement.reason;
}

TEST(BumpHints, SayThatAPointGetsItsNormalFromTheOneBefore) {
    Vector3 before{1.0, 0.0, 0.0};
    const TaskJudgement judgement = judge([&](const Point& point) {
        const Vector3 normal = modelNormal({}, Mistake::none, point);
        const Vector3 mean = (normal + 0.5 * before).normalised();
        before = normal;
        return mean;
    });
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.reason, "another order")) << judgement.reason;
}

TEST(JudgeBump, SaysThatTheLastRowKeepsTheSlopeOfTheCallBefore) {
    double slopeV = 0.0;
    const TaskJudgement judgement =
        judge(inProportion(kParametrisation, [&](const Place& at, const Point& point) {
            if (at.row < point.map.height() - 1) slopeV = at.alongV;
            return std::pair{1.0, at.alongV == 0.0 ? 1.0 : slopeV / at.alongV};
        }));
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.reason, "another order")) << judgement.reason;
}

TEST(BumpHints, TellTheHalfOnWhichASignIsWrong) {
    const TaskJudgement judgement = judge({}, Mistake::uHemisphere);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_TRUE(contains(judgement.reason, "inverted from 50 % to 100 %")) << judgement.reason;
}

}  // namespace
}  // namespace ticker::tests
