#include <grader/tests/tasks/bump/Judging.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ticker::tests {
namespace {

using selftest::Mistake;
using selftest::modelNormal;

TEST(BumpSpecialPoints, NamesTheTexelOfAnExceptionAndBlocks) {
    const TaskJudgement judgement = judge({}, Mistake::noWrap);
    EXPECT_EQ(judgement.state, TaskState::blocked);
    ASSERT_EQ(firstId(judgement), "run.crashed");
    EXPECT_NE(judgement.reason.find("column"), std::string::npos);
    EXPECT_NE(judgement.reason.find("texels"), std::string::npos);
}

TEST(BumpSpecialPoints, ShowsNoControlCharacterOfAnException) {
    const TaskJudgement judgement = judge([](const Point&) -> Vector3 {
        throw std::runtime_error("\x1b[31m" + std::string(999, 'x'));
    });
    ASSERT_EQ(firstId(judgement), "run.crashed");
    EXPECT_EQ(judgement.reason.find('\x1b'), std::string::npos);
    EXPECT_LT(judgement.reason.size(), 600U);
}

/// A right reading, changed by `special` at some points.
template <typename IsSpecial, typename Special>
TaskJudgement judgeWith(IsSpecial isSpecial, Special special) {
    return judge([=](const Point& point) {
        if (isSpecial(smooth(point))) return special();
        return modelNormal({}, Mistake::none, point);
    });
}

Vector3 nothing() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
}

Vector3 outside() {
    throw raytracer::Error("heightMap().at(column 90, row 3) is outside the map of 90 x 70 texels");
}

TEST(BumpSpecialPoints, OnlyWarnsOfNormalsThatAreNoNumbersAtThePoles) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return std::abs(n.y) == 1.0; }, nothing);
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_EQ(firstId(judgement), "bump.not-finite");
    EXPECT_EQ(judgement.findings.front().severity, Severity::warn);
}

TEST(BumpSpecialPoints, OnlyWarnsOfExceptionsWhereNoPictureGoes) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return n.x == 0.0 && n.z > 0.0; }, outside);
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_EQ(firstId(judgement), "run.crashed");
    EXPECT_EQ(judgement.findings.front().severity, Severity::warn);
}

TEST(BumpSpecialPoints, BlocksOnAnExceptionInThePicturesMiddleColumn) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return n.x == 0.0 && n.z < 0.0; }, outside);
    EXPECT_EQ(judgement.state, TaskState::blocked);
    EXPECT_EQ(firstId(judgement), "run.crashed");
}

TEST(BumpSpecialPoints, FailsNormalsThatAreNoNumbersInThePicturesMiddleRow) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return n.y == 0.0 && n.z < 0.0 && n.x != 0.0; }, nothing);
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(firstId(judgement), "bump.not-finite");
}

TEST(BumpSpecialPoints, FailsWhatIsRightOnTheNearSideOnly) {
    const TaskJudgement judgement = judgeWith([](const Vector3& n) { return n.z > 0.3; },
                                              [] {
                                                  return Vector3{0.0, 0.0, 1.0};
                                              });
    EXPECT_EQ(judgement.state, TaskState::failed);
}

}  // namespace
}  // namespace ticker::tests
