#include <grader/tests/tasks/bump/Judging.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace ticker::tests {
namespace {

using probe::ProcessEnd;
using selftest::FunctionExaminee;
using selftest::Mistake;
using selftest::modelNormal;
using selftest::Reading;
using tasks::judgeBump;

const EvidenceValue* evidence(const TaskJudgement& judgement, const std::string& key) {
    for (const auto& [name, value] : judgement.findings.front().evidence)
        if (name == key) return &value;
    return nullptr;
}

/// Ends every run in a given way, without an answer.
class Broken final : public probe::Examinee {
public:
    explicit Broken(ProcessEnd::Kind kind) : kind_(kind) {}
    probe::Run ask(const std::vector<probe::Question>&) override {
        return {{}, {kind_, "some detail"}};
    }

private:
    ProcessEnd::Kind kind_;
};

TEST(JudgeBump, PassesARightReadingInOneRunWithoutFindings) {
    FunctionExaminee examinee(
        [](const Point& point) { return modelNormal({}, Mistake::none, point); });
    const TaskJudgement judgement = judgeBump(examinee, 1);
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.findings.empty());
    EXPECT_EQ(examinee.runs(), 1);
}

TEST(JudgeBump, AsksCodeWithAMistakeInTwoRuns) {
    FunctionExaminee examinee(
        [](const Point& point) { return modelNormal({}, Mistake::inverted, point); });
    (void)judgeBump(examinee, 1);
    EXPECT_EQ(examinee.runs(), 2);
}

TEST(JudgeBump, SaysTheSameForTheSameSeed) {
    const TaskJudgement one = judge({}, Mistake::otherAxis);
    const TaskJudgement two = judge({}, Mistake::otherAxis);
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
        EXPECT_EQ(firstId(judge(reading, Mistake::invertedV)), "bump.inverted-v") << strength;
    }
}

TEST(JudgeBump, MakesUpForTheLeanOfADisplacedSurfacesChords) {
    Reading reading;
    reading.gain = Reading::Gain::displacedUnit;
    reading.difference = Reading::Difference::forward;
    for (const double strength : {0.2, 1.0, 5.0, 20.0}) {  // radius 1 + 0.005 to 0.5 x height
        reading.strength = strength;
        EXPECT_EQ(judge(reading).state, TaskState::passed) << strength;
        EXPECT_EQ(firstId(judge(reading, Mistake::inverted)), "bump.inverted") << strength;
        EXPECT_EQ(firstId(judge(reading, Mistake::invertedU)), "bump.inverted-u") << strength;
    }
}

TEST(JudgeBump, RefusesALeanThatIsMoreThanThatOfChords) {
    const auto leaning = [](double lean) {
        return judge([=](const Point& point) {
            const Vector3 n = smooth(point);
            const Vector3 right = n.cross({0.0, 1.0, 0.0}).normalised();
            return (modelNormal({}, Mistake::none, point) + right * lean).normalised();
        });
    };
    EXPECT_EQ(leaning(0.03).state, TaskState::passed);
    EXPECT_EQ(firstId(leaning(0.2)), "bump.wrong");
}

TEST(JudgeBump, ListsNoFindingTwice) {
    // Half of the right length everywhere, at visible and at hidden points.
    const TaskJudgement judgement =
        judge([](const Point& point) { return 0.5 * modelNormal({}, Mistake::none, point); });
    const auto listed = std::count_if(judgement.findings.begin(), judgement.findings.end(),
                                      [](const Finding& f) { return f.id == "bump.not-unit"; });
    EXPECT_EQ(listed, 1);
}

TEST(JudgeBump, CallsAnInvisibleTiltFlat) {
    Reading reading;
    reading.strength = 1e-5;
    EXPECT_EQ(firstId(judge(reading)), "bump.flat");
    EXPECT_EQ(firstId(judge(smooth)), "bump.flat");
}

TEST(JudgeBump, ReportsTheFirstFaultAndTheOthersAsEvidence) {
    const TaskJudgement judgement =
        judge([](const Point& point) { return 1.1 * modelNormal({}, Mistake::invertedU, point); });
    ASSERT_EQ(firstId(judgement), "bump.not-unit");
    EXPECT_EQ(std::get<std::string>(*evidence(judgement, "also")), "bump.inverted-u");
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
        ASSERT_EQ(firstId(judgement), id);
        EXPECT_FALSE(judgement.findings.front().hint.empty()) << id;
        EXPECT_TRUE(judgement.reason.ends_with(" (some detail).")) << judgement.reason;
    }
}

TEST(JudgeBump, NeverBlamesTheStudentForOurFault) {
    Broken examinee(ProcessEnd::Kind::ourFault);
    const TaskJudgement judgement = judgeBump(examinee, 1);
    EXPECT_EQ(judgement.state, TaskState::notGraded);
    EXPECT_TRUE(judgement.findings.empty());
}

TEST(JudgeBump, TellsACentreThatIsMissingByASphereAtTheOrigin) {
    const TaskJudgement judgement = judge({}, Mistake::noCentre);
    ASSERT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.findings.front().hint.find("centre is not subtracted"), std::string::npos);
}

/// Code that replaces each point by its reflection along these axes.
TaskJudgement judgeReflected(Mistake mistake, const Vector3& signs, bool turnedBack) {
    return judge([=](const Point& point) {
        const auto reflected = [&](const Vector3& v) {
            return Vector3{v.x * signs.x, v.y * signs.y, v.z * signs.z};
        };
        Point other = point;
        other.position = point.centre + reflected(point.position - point.centre);
        const Vector3 normal = modelNormal({}, mistake, other);
        return turnedBack ? reflected(normal) : normal;
    });
}

TEST(JudgeBump, SaysFirstThatEveryNormalPointsInwards) {
    const TaskJudgement judgement = judgeReflected(Mistake::none, {-1.0, -1.0, -1.0}, false);
    ASSERT_EQ(judgement.findings.size(), 1U) << "where the map lies is another matter";
    EXPECT_EQ(firstId(judgement), "bump.wrong");
    EXPECT_NE(judgement.reason.find("points into the sphere"), std::string::npos);
}

TEST(JudgeBump, DoesNotCallAMapMirroredThatStandsOnItsHead) {
    const TaskJudgement judgement = judgeReflected(Mistake::none, {1.0, -1.0, 1.0}, true);
    ASSERT_EQ(judgement.findings.size(), 1U);
    EXPECT_EQ(firstId(judgement), "bump.upside-down");
}

TEST(JudgeBump, SaysOfAnInvertedAxisThatTheMapStandsOnItsHead) {
    const TaskJudgement judgement = judgeReflected(Mistake::invertedV, {1.0, -1.0, 1.0}, true);
    ASSERT_EQ(judgement.findings.size(), 1U);
    EXPECT_EQ(firstId(judgement), "bump.inverted-v");
    EXPECT_NE(judgement.reason.find("stands on its head"), std::string::npos);
    EXPECT_EQ(judgement.findings.front().hint.rfind("Turn the map round first", 0), 0U);
}

}  // namespace
}  // namespace ticker::tests
