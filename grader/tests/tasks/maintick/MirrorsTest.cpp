#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/mirrors/MirrorQuestions.h>
#include <grader/tasks/support/Surfaces.h>
#include <grader/tests/tasks/maintick/RightAnswers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ticker::tasks {
namespace {

using maintick::MirrorQuestion;
using raytracer::SceneDescription;

constexpr std::uint64_t kMirrorSeed = 2;

/// What the examinee does with mirrors.
struct Mirrors {
    maintick::TraceWay way = {};
    double bias = -1.0;   ///< of the one ray that is logged; negative: no log
    double facing = 1.0;  ///< factor of the last colour of two mirrors that face each other
    double direct = 1.0;  ///< factor of what trace gives of all surfaces
    int deepest = 1000;   ///< most bounces between mirrors that face each other
    /// The first question that has no answer, of those that are asked after the open scene: 1 are
    /// mirrors that face each other, 3 those with many bounces, 5 a grazed mirror.
    std::size_t endsAt = 1000;
    bool isFirstDeepThere = true;  ///< with endsAt 3: the ray with the fewest bounces has an answer
    probe::ProcessEnd::Kind end = probe::ProcessEnd::Kind::crashed;
};

class TracesByModel final : public probe::Examinee {
public:
    explicit TracesByModel(const Mirrors& mirrors) : mirrors_(mirrors) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        if (std::holds_alternative<probe::RenderQuestion>(questions.at(0))) return {};
        probe::Run run;
        constexpr std::size_t kBeforeMixed = 4;
        const std::size_t end = std::min(questions.size(), kBeforeMixed);
        for (std::size_t i = 0; i < end; i += 2)
            answer(run, std::get<probe::IlluminateQuestion>(questions[i]),
                   std::get<probe::TraceQuestion>(questions[i + 1]));
        for (std::size_t i = end; i < questions.size(); ++i)
            run.answers.push_back(rightAnswer(questions[i]));
        const bool isOpenScene = questions.size() == 2;
        if (!isOpenScene && mirrors_.endsAt < questions.size()) cutShort(run, questions);
        return run;
    }

private:
    // Out of time only where the most bounces are asked for.
    void cutShort(probe::Run& run, const std::vector<probe::Question>& questions) const {
        const auto& deep = std::get<probe::TraceQuestion>(questions.at(3));
        const bool isTooSlow = deep.rays.back().bounces == maintick::kDeepest;
        if (mirrors_.end == probe::ProcessEnd::Kind::timedOut && !isTooSlow) return;
        run.end.kind = mirrors_.end;
        for (std::size_t i = mirrors_.endsAt; i < run.answers.size(); ++i)
            std::visit([](auto& answer) { answer.state = {}; }, run.answers[i]);
        if (!mirrors_.isFirstDeepThere)
            std::get<probe::IlluminateAnswer>(run.answers.at(3)).colours.clear();
    }
    void answer(probe::Run& run, const probe::IlluminateQuestion& points,
                const probe::TraceQuestion& rays) const {
        probe::IlluminateAnswer direct;
        direct.state = probe::AnswerState::answered;
        const bool isLit = !points.scene.pointLights.empty();
        for (std::size_t i = 0; i < points.points.size(); ++i)
            direct.colours.push_back(
                isLit ? ColourRGB{1.0 + 2.0 * static_cast<double>(i)}
                      : points.scene.ambientLighting *
                            materialOf(points.scene, points.points[i].object).colour);
        const bool isDeep = points.scene.spheres.empty() && !isLit;
        run.answers.emplace_back(direct);
        run.answers.emplace_back(
            isLit ? facing(direct.colours)
                  : open(rays, direct.colours, isDeep ? mirrors_.deepest : 1000));
    }
    // By hand: the floor mirrors 0.5, the wall 0.45.
    [[nodiscard]] probe::IlluminateAnswer facing(const std::vector<ColourRGB>& d) const {
        probe::IlluminateAnswer answer;
        answer.state = probe::AnswerState::answered;
        answer.colours = {d[0], d[0] * 0.5 + d[1] * 0.5,
                          (d[0] * 0.5 + (d[1] * 0.55 + d[2] * 0.45) * 0.5) * mirrors_.facing};
        return answer;
    }
    [[nodiscard]] probe::IlluminateAnswer open(const probe::TraceQuestion& asked,
                                               const std::vector<ColourRGB>& direct,
                                               int deepest) const {
        probe::IlluminateAnswer answer;
        answer.state = probe::AnswerState::answered;
        for (const probe::CastRay& cast : asked.rays)
            answer.colours.push_back(
                maintick::TraceModel{asked.scene, direct, mirrors_.way}.along(
                    {cast.origin, cast.direction}, std::min(cast.bounces, deepest)) *
                mirrors_.direct);
        if (mirrors_.bias >= 0.0) answer.events = logOfSecondRay(asked);
        return answer;
    }
    [[nodiscard]] std::vector<probe::Event> logOfSecondRay(
        const probe::TraceQuestion& asked) const {
        const probe::CastRay& cast = asked.rays.at(1);
        const auto met = maintick::nearestOn(asked.scene, {cast.origin, cast.direction});
        const Vector3 N = met->meeting.normal;
        probe::Event first;
        first.ask = 1;
        first.a = cast.origin;
        first.b = cast.direction;
        probe::Event second = first;
        second.a = met->meeting.location + N * mirrors_.bias;
        second.b = (-cast.direction).reflectIn(N) * 2.0;
        return {first, second};
    }

    Mirrors mirrors_;
};

std::string mirrorIds(const Mirrors& mirrors) {
    TracesByModel examinee{mirrors};
    std::string ids;
    for (const Finding& finding : judgeReflections(examinee, kMirrorSeed).findings)
        ids += finding.id;
    return ids;
}

TEST(JudgeMirrors, AcceptsRaysThatStartAtMostAThousandthAboveTheSurface) {
    EXPECT_EQ(mirrorIds({}), "");
    EXPECT_EQ(mirrorIds({.bias = 0.0}), "");
    EXPECT_EQ(mirrorIds({.bias = 1.09e-3}), "");
    EXPECT_EQ(mirrorIds({.bias = 1.11e-3}), "mirror.start");
    EXPECT_EQ(mirrorIds({.bias = 0.29}), "mirror.start");
    EXPECT_EQ(mirrorIds({.bias = 0.31}), "") << "that is no reflected ray";
}

TEST(JudgeMirrors, BlamesAStartOnTheSurfaceOnlyWhereColoursAreWrong) {
    EXPECT_EQ(mirrorIds({.bias = 0.0, .direct = 1.1}), "mirror.start");
    EXPECT_EQ(mirrorIds({.bias = 1e-4, .direct = 1.1}), "mirror.base");
    EXPECT_EQ(mirrorIds({.direct = 1.1}), "mirror.base");
}

TEST(JudgeMirrors, NameAnEndByTheQuestionThatHasNoAnswer) {
    EXPECT_EQ(mirrorIds({.endsAt = 1}), "mirror.endless");
    EXPECT_EQ(mirrorIds({.endsAt = 3}), "mirror.bounces") << "an array of 16 reflections";
    EXPECT_EQ(mirrorIds({.endsAt = 3, .isFirstDeepThere = false}), "mirror.endless");
    EXPECT_EQ(mirrorIds({.endsAt = 5}), "run.crashed");
}

// It calls trace three times for each reflection: 3^18 calls take minutes, 3^10 do not.
TEST(JudgeMirrors, AcceptCodeThatIsTooSlowForTheMostBouncesAlone) {
    constexpr auto kTimedOut = probe::ProcessEnd::Kind::timedOut;
    EXPECT_EQ(mirrorIds({.endsAt = 3, .end = kTimedOut}), "");
    EXPECT_EQ(mirrorIds({.deepest = 8, .endsAt = 3, .end = kTimedOut}), "mirror.bounces");
}

TEST(JudgeMirrors, WorksOutTwoMirrorsThatFaceEachOther) {
    EXPECT_EQ(mirrorIds({.facing = 1.003}), "");
    EXPECT_EQ(mirrorIds({.facing = 1.005}), "mirror.wrong");
    EXPECT_EQ(mirrorIds({.endsAt = 1}), "mirror.endless");
    EXPECT_EQ(mirrorIds({.way = maintick::noMirrors().way, .endsAt = 1}), "mirror.none");
}

TEST(JudgeMirrors, FollowsUpToFortyReflections) {
    for (int deepest = 3; deepest < maintick::kDeepest; ++deepest)
        EXPECT_EQ(mirrorIds({.deepest = deepest}), "mirror.bounces") << deepest;
    EXPECT_EQ(mirrorIds({.deepest = maintick::kDeepest}), "");
}

TEST(JudgeMirrors, NamesTheMistakeThatExplainsAllColours) {
    EXPECT_EQ(mirrorIds({.way = maintick::noMirrors().way}), "mirror.none");
    for (const maintick::TraceMistake& mistake : maintick::traceMistakes()) {
        // Rays into the surface give the same colours as no mirrors; only the log tells them apart.
        const std::string id = mirrorIds({.way = mistake.way});
        if (id != "mirror.none") {
            EXPECT_EQ(id, mistake.finding->id) << mistake.hint;
        }
    }
}

// A limit of the depth shows under every seed, whatever the code returns where it ends.
TEST(MirrorQuestions, GiveAnotherColourForEveryLimitOfTheDepth) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const MirrorQuestion asked = maintick::drawDeepMirrors(seed);
        const SceneDescription& scene = asked.question.scene;
        std::vector<ColourRGB> direct;
        for (const auto& plane : scene.planes)
            direct.push_back(plane.material.colour * scene.ambientLighting);
        const maintick::TraceModel trace{scene, direct};
        const probe::CastRay& cast = asked.question.rays.back();
        ASSERT_EQ(cast.bounces, maintick::kDeepest);
        const raytracer::Ray ray{cast.origin, cast.direction};
        for (int limit = 11; limit < cast.bounces; ++limit)
            EXPECT_FALSE(
                maintick::isNear(trace.along(ray, limit), trace.along(ray, cast.bounces), 1e-3))
                << limit << ", seed " << seed;
        for (int bounces = 1; bounces < 10; ++bounces)
            EXPECT_FALSE(
                maintick::isNear(trace.along(ray, bounces), trace.along(ray, bounces + 1), 1e-2))
                << bounces << ", seed " << seed;
        for (const maintick::MirrorStart& start :
             {maintick::MirrorStart{1e-6, false}, maintick::MirrorStart{1e-3, true}}) {
            const std::vector<int> chain = maintick::chainOf(scene, ray, cast.bounces + 1, start);
            ASSERT_EQ(chain.size(), static_cast<std::size_t>(cast.bounces + 1)) << seed;
            for (std::size_t i = 0; i < chain.size(); ++i)
                EXPECT_EQ(chain[i], static_cast<int>(i % 2)) << seed;
        }
    }
}

TEST(MirrorQuestions, LookStraightDownAtTheDullBallAndUpAtTheWeakMirror) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const MirrorQuestion asked = maintick::drawOpenScene(seed);
        const auto& rays = asked.question.rays;
        const auto shareMet = [&](const probe::CastRay& ray) {
            const auto met = maintick::nearestOn(asked.question.scene, {ray.origin, ray.direction});
            return materialOf(asked.question.scene, met.value().object).reflectivity;
        };
        EXPECT_EQ(shareMet(rays.at(rays.size() - 9)), 0.0) << seed;
        EXPECT_GT(shareMet(rays.at(rays.size() - 5)), 0.92) << seed;
        EXPECT_EQ(shareMet(rays.back()), 0.03) << seed;
    }
}

}  // namespace
}  // namespace ticker::tasks
