#include <grader/decision/bump/JudgeBump.h>
#include <grader/selftest/BumpModel.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ticker::tests {
namespace {

using decision::judgeBump;
using decision::TaskJudgement;
using probe::ProcessEnd;
using raytracer::Vector3;
using selftest::FunctionExaminee;
using selftest::modelNormal;
using selftest::NormalFunction;
using selftest::Point;
using selftest::Reading;
using selftest::Slip;

TaskJudgement judge(const NormalFunction& function, std::uint64_t seed = 5) {
    FunctionExaminee examinee(function);
    return judgeBump(examinee, seed);
}

TaskJudgement judge(const Reading& reading, Slip slip = Slip::none) {
    return judge([&](const Point& point) { return modelNormal(reading, slip, point); });
}

std::string firstId(const TaskJudgement& judgement) {
    return judgement.findings.empty() ? std::string{} : judgement.findings.front().id;
}

const EvidenceValue* evidence(const TaskJudgement& judgement, const std::string& key) {
    for (const auto& [name, value] : judgement.findings.front().evidence)
        if (name == key) return &value;
    return nullptr;
}

Vector3 smooth(const Point& point) {
    return (point.position - point.centre).normalised();
}

/// Ends every sitting in a given way, without an answer.
class Broken final : public probe::Examinee {
public:
    explicit Broken(ProcessEnd::Kind kind) : kind_(kind) {}
    probe::Sitting ask(const std::vector<probe::Question>&) override {
        return {{}, {kind_, "some detail"}};
    }

private:
    ProcessEnd::Kind kind_;
};

TEST(JudgeBump, PassesARightReadingInOneSittingWithoutFindings) {
    FunctionExaminee examinee(
        [](const Point& point) { return modelNormal({}, Slip::none, point); });
    const TaskJudgement judgement = judgeBump(examinee, 1);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.findings.empty());
    EXPECT_EQ(examinee.sittings(), 1);
}

TEST(JudgeBump, NeedsTwoSittingsAtMost) {
    FunctionExaminee examinee(
        [](const Point& point) { return modelNormal({}, Slip::inverted, point); });
    (void)judgeBump(examinee, 1);
    EXPECT_EQ(examinee.sittings(), 2);
}

TEST(JudgeBump, SaysTheSameForTheSameSeed) {
    const TaskJudgement one = judge({}, Slip::otherAxis);
    const TaskJudgement two = judge({}, Slip::otherAxis);
    ASSERT_EQ(firstId(one), firstId(two));
    EXPECT_EQ(one.findings.front().message, two.findings.front().message);
    EXPECT_EQ(one.findings.front().evidence, two.findings.front().evidence);
}

TEST(JudgeBump, NotesMirroredTextAndPasses) {
    Reading reading;
    reading.mirrored = true;
    const TaskJudgement judgement = judge(reading);
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_EQ(firstId(judgement), "bump.mirrored");
    EXPECT_EQ(judgement.findings.front().severity, Severity::note);
}

TEST(JudgeBump, JudgesTheSignWhateverTheStrength) {
    for (const double strength : {1e-3, 0.02, 0.2, 20.0, 500.0}) {
        Reading reading;
        reading.strength = strength;
        EXPECT_EQ(judge(reading).state, TaskState::passed) << strength;
        EXPECT_EQ(firstId(judge(reading, Slip::invertedV)), "bump.inverted-v") << strength;
    }
}

TEST(JudgeBump, MakesUpForTheLeanOfADisplacedSurfacesChords) {
    Reading reading;
    reading.gain = Reading::Gain::displacedUnit;
    reading.difference = Reading::Difference::forward;
    for (const double strength : {0.2, 1.0, 5.0, 20.0}) {  // 1 + 0.005 to 0.5 times the height
        reading.strength = strength;
        EXPECT_EQ(judge(reading).state, TaskState::passed) << strength;
        EXPECT_EQ(firstId(judge(reading, Slip::inverted)), "bump.inverted") << strength;
        EXPECT_EQ(firstId(judge(reading, Slip::invertedU)), "bump.inverted-u") << strength;
    }
}

TEST(JudgeBump, RefusesALeanThatIsMoreThanThatOfChords) {
    const auto leaning = [](double lean) {
        return judge([=](const Point& point) {
            const Vector3 n = smooth(point);
            const Vector3 right = n.cross({0.0, 1.0, 0.0}).normalised();
            return (modelNormal({}, Slip::none, point) + right * lean).normalised();
        });
    };
    EXPECT_EQ(leaning(0.03).state, TaskState::passed);
    EXPECT_EQ(firstId(leaning(0.2)), "bump.wrong");
}

TEST(JudgeBump, ListsNoFindingTwice) {
    // Half as long everywhere: at points that show, and at those that do not.
    const TaskJudgement judgement =
        judge([](const Point& point) { return 0.5 * modelNormal({}, Slip::none, point); });
    const auto listed = std::count_if(judgement.findings.begin(), judgement.findings.end(),
                                      [](const Finding& f) { return f.id == "bump.not-unit"; });
    EXPECT_EQ(listed, 1);
}

TEST(JudgeBump, CallsATiltThatNobodyCanSeeFlat) {
    Reading reading;
    reading.strength = 1e-5;
    EXPECT_EQ(firstId(judge(reading)), "bump.flat");
    EXPECT_EQ(firstId(judge(smooth)), "bump.flat");
}

TEST(JudgeBump, ShowsTheHalfInvertedLettersInWordsAndPictures) {
    const TaskJudgement judgement = judge({}, Slip::invertedU);
    ASSERT_EQ(firstId(judgement), "bump.inverted-u");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "letterH")), "half");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "letterL")), "half");
    const std::vector<Raster>& rasters = judgement.findings.front().rasters;
    ASSERT_EQ(rasters.size(), 2U);
    for (const Raster& raster : rasters)
        EXPECT_EQ(raster.values.size(), static_cast<std::size_t>(raster.width * raster.height));
}

/// The correlation of two pictures.
double likeness(const std::vector<float>& a, const std::vector<float>& b) {
    double meanA = 0.0;
    double meanB = 0.0;
    const auto count = static_cast<double>(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        meanA += a[i] / count, meanB += b[i] / count;
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - meanA) * (a[i] - meanA);
        bb += (b[i] - meanB) * (b[i] - meanB);
        ab += (a[i] - meanA) * (b[i] - meanB);
    }
    return ab / std::sqrt(aa * bb);
}

TEST(JudgeBump, RecoversTheReliefThatTheNormalsShow) {
    // Inverted along both axes, so the picture must be the negative of the true one.
    const TaskJudgement inverted = judge({}, Slip::inverted);
    const std::vector<Raster>& lowered = inverted.findings.front().rasters;
    EXPECT_LT(likeness(lowered.at(0).values, lowered.at(1).values), -0.9);
    EXPECT_EQ(std::get<std::string>(*evidence(inverted, "letterH")), "lowered");
    EXPECT_EQ(std::get<std::string>(*evidence(inverted, "letterL")), "raised");
    // Upside down, but raised.
    const TaskJudgement turned = judge({}, Slip::upsideDown);
    const std::vector<Raster>& raised = turned.findings.front().rasters;
    EXPECT_GT(likeness(raised.at(0).values, raised.at(1).values), 0.9);
}

TEST(JudgeBump, ReportsTheFirstFaultAndTheOthersAsEvidence) {
    const TaskJudgement judgement =
        judge([](const Point& point) { return 1.1 * modelNormal({}, Slip::invertedU, point); });
    ASSERT_EQ(firstId(judgement), "bump.not-unit");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "also")), "bump.inverted-u");
}

TEST(JudgeBump, NamesTheTexelOfAnExceptionAndBlocks) {
    const TaskJudgement judgement = judge({}, Slip::noWrap);
    EXPECT_EQ(judgement.state, TaskState::blocked);
    ASSERT_EQ(firstId(judgement), "run.crashed");
    EXPECT_NE(judgement.reason.find("column"), std::string::npos);
    EXPECT_NE(judgement.reason.find("texels"), std::string::npos);
}

TEST(JudgeBump, ShowsNoControlCharacterOfAnException) {
    const TaskJudgement judgement = judge([](const Point&) -> Vector3 {
        throw std::runtime_error("\x1b[31m" + std::string(999, 'x'));
    });
    ASSERT_EQ(firstId(judgement), "run.crashed");
    EXPECT_EQ(judgement.reason.find('\x1b'), std::string::npos);
    EXPECT_LT(judgement.reason.size(), 600U);
}

/// A right reading but for what `special` makes of some points.
template <typename IsSpecial, typename Special>
TaskJudgement judgeWith(IsSpecial isSpecial, Special special) {
    return judge([=](const Point& point) {
        if (isSpecial(smooth(point))) return special();
        return modelNormal({}, Slip::none, point);
    });
}

Vector3 nothing() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
}

Vector3 outside() {
    throw raytracer::Error("heightMap().at(column 90, row 3) is outside the map of 90 x 70 texels");
}

TEST(JudgeBump, OnlyWarnsOfNormalsThatAreNoNumbersAtThePoles) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return std::abs(n.y) == 1.0; }, nothing);
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_EQ(firstId(judgement), "bump.not-finite");
    EXPECT_EQ(judgement.findings.front().severity, Severity::warn);
}

TEST(JudgeBump, OnlyWarnsOfExceptionsWhereNoPictureGoes) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return n.x == 0.0 && n.z > 0.0; }, outside);
    EXPECT_EQ(judgement.state, TaskState::passed);
    ASSERT_EQ(firstId(judgement), "run.crashed");
    EXPECT_EQ(judgement.findings.front().severity, Severity::warn);
}

TEST(JudgeBump, BlocksOnAnExceptionInThePicturesMiddleColumn) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return n.x == 0.0 && n.z < 0.0; }, outside);
    EXPECT_EQ(judgement.state, TaskState::blocked);
    EXPECT_EQ(firstId(judgement), "run.crashed");
}

TEST(JudgeBump, FailsNormalsThatAreNoNumbersInThePicturesMiddleRow) {
    const TaskJudgement judgement =
        judgeWith([](const Vector3& n) { return n.y == 0.0 && n.z < 0.0 && n.x != 0.0; }, nothing);
    EXPECT_EQ(judgement.state, TaskState::failed);
    EXPECT_EQ(firstId(judgement), "bump.not-finite");
}

TEST(JudgeBump, FailsWhatIsRightOnTheNearSideOnly) {
    const TaskJudgement judgement = judgeWith([](const Vector3& n) { return n.z > 0.3; },
                                              [] {
                                                  return Vector3{0.0, 0.0, 1.0};
                                              });
    EXPECT_EQ(judgement.state, TaskState::failed);
}

TEST(JudgeBump, GivesEveryBadEndItsOwnFinding) {
    const std::pair<ProcessEnd::Kind, const char*> ends[] = {
        {ProcessEnd::Kind::crashed, "run.crashed"},
        {ProcessEnd::Kind::exitedEarly, "run.exited-early"},
        {ProcessEnd::Kind::timedOut, "run.timed-out"},
        {ProcessEnd::Kind::memory, "run.memory"},
        {ProcessEnd::Kind::outputLimit, "run.output-limit"},
        {ProcessEnd::Kind::forbiddenCall, "run.forbidden-call"},
        {ProcessEnd::Kind::finished, "run.no-answer"},
    };
    for (const auto& [kind, id] : ends) {
        Broken examinee(kind);
        const TaskJudgement judgement = judgeBump(examinee, 1);
        EXPECT_EQ(judgement.state, TaskState::blocked) << id;
        EXPECT_EQ(firstId(judgement), id);
    }
}

TEST(JudgeBump, NeverBlamesTheStudentForOurFault) {
    Broken examinee(ProcessEnd::Kind::ourFault);
    const TaskJudgement judgement = judgeBump(examinee, 1);
    EXPECT_EQ(judgement.state, TaskState::notGraded);
    EXPECT_TRUE(judgement.findings.empty());
}

TEST(JudgeBump, TellsACentreThatIsMissingByASphereAtTheOrigin) {
    const TaskJudgement judgement = judge({}, Slip::noCentre);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.findings.front().hint.find("centre is not subtracted"), std::string::npos);
}

}  // namespace
}  // namespace ticker::tests
