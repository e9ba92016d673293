// Light whose falloff takes the distance to the near side of the light's ball, as where rays meet
// the ball as an object.
#include <grader/tasks/shadows/JudgeShadows.h>
#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/support/LocalExaminee.h>
#include <grader/tests/support/SlowRun.h>
#include <grader/tests/tasks/support/InFinding.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

/// The place whose distance the falloff takes: the light's centre, or a place on the sample's line
/// inside of the light's ball.
enum class Side { centre, middle, near, anywhere, eitherEnd };

/// The reference's shadow rays with light of another falloff; the rays are hidden if told to.
class Refalling final : public probe::Examinee {
public:
    Refalling(Side side, bool perSample, bool hideRays)
        : side_(side), perSample_(perSample), hideRays_(hideRays) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        std::vector<probe::Question> logged = questions;
        for (probe::Question& question : logged)
            if (auto* asked = std::get_if<probe::IlluminateQuestion>(&question))
                asked->eventCapacity = static_cast<std::uint32_t>(
                    asked->points.size() * asked->scene.pointLights.size() * 16U);
        probe::Run run = reference_.ask(logged);
        for (std::size_t i = 0; i < run.answers.size(); ++i)
            if (auto* answer = std::get_if<probe::IlluminateAnswer>(&run.answers[i]))
                change(std::get<probe::IlluminateQuestion>(logged[i]), *answer);
        return run;
    }

private:
    void change(const probe::IlluminateQuestion& asked, probe::IlluminateAnswer& answer) {
        ShadowQuestion question;
        question.question = asked;
        question.zones.assign(asked.points.size(),
                              std::vector<Zone>(asked.scene.pointLights.size(), Zone::penumbra));
        const ShadowLog log = readShadowLog(question, answer);
        for (std::size_t i = 0; i < log.points.size(); ++i)
            answer.colours[i] = colourOf(log.points[i], log);
        if (hideRays_) answer.events.clear();
    }

    [[nodiscard]] ColourRGB colourOf(const PointLog& point, const ShadowLog& log) {
        ColourRGB colour = ambientPart(point, log.scene());
        for (std::size_t light = 0; light < point.lines.size(); ++light)
            for (const AimLine& line : point.lines[light])
                if (line.toLight == Sight::open)
                    colour += lightOf(point, log, light, line) /
                              static_cast<double>(point.lines[light].size());
        return colour;
    }

    [[nodiscard]] ColourRGB lightOf(const PointLog& point, const ShadowLog& log, std::size_t light,
                                    const AimLine& line) {
        const raytracer::PointLight& lamp = log.scene().pointLights[light];
        const Vector3 towards = lamp.position() - point.point.position;
        const double centre = towards.magnitude();
        const double along = (lamp.position() - line.origin).dot(line.direction);
        const double radius = log.settings().lightSize;
        const double half = std::sqrt(std::max(0.0, radius * radius - line.miss * line.miss));
        const double place = side_ == Side::near       ? -1.0
                             : side_ == Side::anywhere ? draw_.between(-1.0, 1.0)
                             : side_ == Side::eitherEnd
                                 ? (draw_.between(0.0, 1.0) < 0.5 ? -1.0 : 1.0)
                                 : 0.0;
        const double distance = side_ == Side::centre ? centre : along + half * place;
        return phongTerms(materialOf(log.scene(), point.point.object), lamp, point.point.normal,
                          (point.point.viewer - point.point.position).normalised(),
                          perSample_ ? line.direction : towards / centre, distance)
            .sum();
    }

    tests::LocalExaminee reference_;
    Draw draw_{11, 3};
    Side side_;
    bool perSample_;
    bool hideRays_;
};

bool saysNearSide(Side side, bool perSample, bool hideRays, std::uint64_t seed) {
    Refalling examinee{side, perSample, hideRays};
    const TaskJudgement judgement = judgeShadows(examinee, seed);
    EXPECT_EQ(judgement.state, TaskState::passed) << seed;
    EXPECT_FALSE(judgement.needsReview) << seed;
    return std::ranges::any_of(judgement.findings, [](const Finding& finding) {
        return finding.id == "shadow.near-side-falloff" && finding.severity == Severity::warn;
    });
}

TEST(NearSide, IsSaidOfLightThatFallsOffOverTheDistanceOfTheNearSide) {
    for (const bool hideRays : {false, true})
        for (const bool perSample : {false, true})
            EXPECT_TRUE(saysNearSide(Side::near, perSample, hideRays, 5))
                << hideRays << ' ' << perSample;
}

TEST(NearSide, IsNotSaidOfTheCentresDistanceNorOfThatOfEachSample) {
    for (const Side side : {Side::centre, Side::middle, Side::anywhere, Side::eitherEnd})
        for (const bool hideRays : {false, true})
            for (const bool perSample : {false, true}) {
                // Hidden rays are judged by values, which takes ten times as long.
                if (hideRays && !tests::isSlowRun() && (side != Side::eitherEnd || perSample))
                    continue;
                EXPECT_FALSE(saysNearSide(side, perSample, hideRays, 5))
                    << static_cast<int>(side) << ' ' << hideRays << ' ' << perSample;
            }
}

// Code that casts more rays than a log holds is judged by its values.
TEST(NearSide, IsLeftToTheValuesWhereALogIsCut) {
    const std::vector<ShadowQuestion> asked = drawShadowQuestions(5);
    std::vector<probe::Question> questions;
    for (const ShadowQuestion& question : asked)
        questions.emplace_back(question.question);
    Refalling examinee{Side::near, false, false};
    const probe::Run run = examinee.ask(questions);
    std::vector<ShadowLog> logs;
    for (std::size_t i = 0; i < asked.size(); ++i)
        logs.push_back(readShadowLog(asked[i], std::get<probe::IlluminateAnswer>(run.answers[i])));
    EXPECT_EQ(idOf(checkNearSide(ShadowLogs{logs})), "shadow.near-side-falloff");
    logs.front().cut = true;
    EXPECT_FALSE(checkNearSide(ShadowLogs{logs}));
}

}  // namespace
}  // namespace ticker::tasks
