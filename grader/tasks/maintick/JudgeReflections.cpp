#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/maintick/mirrors/MirrorEnd.h>
#include <grader/tasks/maintick/mirrors/MirrorQuestions.h>
#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tasks/support/Shelf.h>

#include <fmt/core.h>

#include <memory>
#include <span>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using maintick::isNear;
using maintick::MirrorQuestion;
using maintick::TraceMistake;
using maintick::words;
using raytracer::ColourRGB;
using raytracer::Vector3;

std::string askedOf(const MirrorQuestion& asked, std::size_t ray) {
    const probe::CastRay& cast = asked.question.rays[ray];
    return fmt::format(
        "trace was asked along the ray from {} in direction {} with {} bounce{} left",
        words(cast.origin), words(cast.direction), cast.bounces, cast.bounces == 1 ? "" : "s");
}

/// Distance from the first hit to the start of the mirrored ray, world units. Empty if no ray in
/// the mirrored direction starts within 0.3 of the hit.
std::optional<double> startOf(const MirrorQuestion& asked, const probe::IlluminateAnswer& answer,
                              std::size_t ray) {
    const probe::CastRay& cast = asked.question.rays[ray];
    const auto first = maintick::nearestOn(asked.question.scene, {cast.origin, cast.direction});
    if (!first || cast.bounces == 0) return std::nullopt;
    const Vector3 R = (-cast.direction).reflectIn(first->meeting.normal);
    constexpr double kElsewhere = 0.3;
    for (const probe::Event& event : answer.events) {
        const double away = (event.a - first->meeting.location).magnitude();
        if (event.kind == probe::Event::Kind::rayCast && event.ask == ray && away < kElsewhere &&
            isNear(event.b.normalised(), R))
            return away;
    }
    return std::nullopt;
}

std::optional<Finding> checkStarts(const MirrorQuestion& asked,
                                   const probe::IlluminateAnswer& answer, bool isWrong) {
    constexpr double kLargestBias = 1.1e-3;
    constexpr double kNoBias = 1e-9;
    for (std::size_t i = 0; i < asked.question.rays.size(); ++i) {
        const auto away = startOf(asked, answer, i);
        if (!away || (*away <= kLargestBias && !(isWrong && *away < kNoBias))) continue;
        return maintick::failure(
            kMirrorStart,
            fmt::format("{}: the mirrored ray was expected to start just above the surface, at "
                        "most 0.001 from it; it starts {:.3g} away.",
                        askedOf(asked, i), *away < kNoBias ? 0.0 : *away));
    }
    return std::nullopt;
}

/// Why every mirror shows only its own colour. A mirrored ray that starts below the surface or goes
/// into it hits that surface again, and the colour is the same as without mirrors. The logged rays
/// tell these mistakes apart.
std::pair<const FindingText*, const char*> whyOnlyItself(const MirrorQuestion& asked,
                                                         const probe::IlluminateAnswer& answer) {
    for (std::size_t i = 0; i + 1 < answer.events.size(); ++i) {
        const probe::Event& first = answer.events[i];
        const probe::Event& second = answer.events[i + 1];
        if (first.ask != second.ask || first.object < 0) continue;
        const auto met = maintick::nearestOn(asked.question.scene, {first.a, first.b});
        if (!met) break;
        const Vector3 N = met->meeting.normal;
        if ((second.a - met->meeting.location).dot(N) < -1e-9)
            return {&kMirrorStart,
                    "The mirrored ray starts below the surface: P + N * kShadowBias, not minus."};
        if (second.b.dot(N) < 0.0)
            return {&kMirrorDirection,
                    "The mirrored ray goes into the surface. reflectIn mirrors what points away "
                    "from it: (-ray.direction).reflectIn(N)."};
        if (!isNear(second.b.normalised(), (-first.b).reflectIn(N))) return {&kMirrorDirection, ""};
        break;
    }
    return {&kMirrorNone, ""};
}

std::optional<Finding> checkColours(const MirrorQuestion& asked,
                                    const std::vector<ColourRGB>& direct,
                                    const probe::IlluminateAnswer& answer) {
    const std::vector<ColourRGB>& given = answer.colours;
    const auto expected = [&](std::size_t i, const TraceMistake* mistake) {
        const probe::CastRay& cast = asked.question.rays[i];
        return maintick::TraceModel{asked.question.scene, direct,
                                    mistake == nullptr ? maintick::TraceWay{} : mistake->way}
            .along({cast.origin, cast.direction}, cast.bounces);
    };
    const auto isRight = [&](std::size_t i, const TraceMistake* mistake) {
        return isNear(given[i], expected(i, mistake));
    };
    const auto first = maintick::firstWrong(given.size(), nullptr, isRight);
    if (!first) return checkStarts(asked, answer, false);
    const std::string seen = fmt::format("{}: expected {}, got {}.", askedOf(asked, *first),
                                         words(expected(*first, nullptr)), words(given[*first]));
    if (!maintick::firstWrong(given.size(), &maintick::noMirrors(), isRight)) {
        const auto [text, hint] = whyOnlyItself(asked, answer);
        return maintick::failure(*text, seen, hint);
    }
    if (auto known = maintick::nameMistake(maintick::traceMistakes(), given.size(), isRight, seen))
        return known;
    if (auto start = checkStarts(asked, answer, true)) return start;
    const bool isBase = asked.question.rays[*first].bounces == 0;
    return maintick::failure(isBase ? kMirrorBase : kMirrorWrong, seen);
}

/// Judges two mirrors that face each other, lit by a point light.
std::optional<Finding> checkLit(const MirrorQuestion& asked, const probe::Run& run) {
    const auto& direct = std::get<probe::IlluminateAnswer>(run.answers.at(0)).colours;
    const auto& given = std::get<probe::IlluminateAnswer>(run.answers.at(1)).colours;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const ColourRGB wanted = maintick::alongChain(asked, direct, static_cast<int>(i));
        if (isNear(given[i], wanted, maintick::kMirrorTolerance)) continue;
        return maintick::failure(
            kMirrorWrong,
            fmt::format("{}: expected {}, got {}, though what illuminate gives of each surface was "
                        "asked before.",
                        askedOf(asked, i), words(wanted), words(given[i])),
            "The light of each surface is illuminate(scene, object, P, N, ray.origin): the viewer "
            "is where this ray starts, behind a mirror, too. And colours above 1 are not cut off.");
    }
    return std::nullopt;
}

/// A question in ambient light alone, the place of its answers, and the words for a wrong one.
struct ChainCheck {
    const MirrorQuestion& asked;
    std::size_t at;  ///< of `direct` among the answers; the rays follow
    const FindingText& text;
    const char* where;
    const char* hint;
};

std::optional<Finding> checkChain(const ChainCheck& check, const probe::Run& run) {
    const MirrorQuestion& asked = check.asked;
    const auto& direct = std::get<probe::IlluminateAnswer>(run.answers.at(check.at)).colours;
    const auto& given = std::get<probe::IlluminateAnswer>(run.answers.at(check.at + 1)).colours;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const probe::CastRay& cast = asked.question.rays[i];
        const ColourRGB wanted = maintick::TraceModel{asked.question.scene, direct}.along(
            {cast.origin, cast.direction}, cast.bounces);
        if (isNear(given[i], wanted)) continue;
        return maintick::failure(check.text,
                                 fmt::format("{}, {}: expected {}, got {}.", askedOf(asked, i),
                                             check.where, words(wanted), words(given[i])),
                                 check.hint);
    }
    return std::nullopt;
}

std::optional<Finding> checkDeep(const MirrorQuestion& asked, const probe::Run& run) {
    return checkChain({asked, 2, kMirrorBounces, "between two mirrors that face each other",
                       "Few reflections are right and more are not: bouncesLeft alone says how "
                       "many are followed. Leave out a limit of your own for their depth or for "
                       "how much they count."},
                      run);
}

std::optional<Finding> checkGrazed(const MirrorQuestion& asked, const probe::Run& run) {
    return checkChain({asked, 4, kMirrorWrong, "which all but grazes a mirror",
                       "A surface mirrors at every angle: leave out a limit of N.D, and a weight "
                       "that depends on it."},
                      run);
}

/// The questions of one seed.
struct MirrorPlan {
    explicit MirrorPlan(std::uint64_t seed)
        : open(maintick::drawOpenScene(seed)),
          facing(maintick::drawFacingMirrors(seed)),
          deep(maintick::drawDeepMirrors(seed)),
          grazed(maintick::drawGrazedMirror(seed)),
          mixed(maintick::drawMixedMirrors(seed)) {}
    MirrorQuestion open;
    MirrorQuestion facing;
    MirrorQuestion deep;
    MirrorQuestion grazed;
    std::vector<maintick::MixedMirror> mixed;
};

/// Judges what the first questions leave open: mirrors that face each other, a mirror that a ray
/// grazes, and mixed scenes.
std::optional<TaskJudgement> askMore(const MirrorPlan& plan, probe::Examinee& examinee,
                                     std::vector<Finding>& findings) {
    constexpr std::size_t kBeforeMixed = 6;
    const auto& [open, facing, deep, grazed, mixed] = plan;
    std::vector<probe::Question> questions{facing.direct, facing.question, deep.direct,
                                           deep.question, grazed.direct,   grazed.question};
    maintick::askMixedMirrors(mixed, questions);
    probe::Run run = examinee.ask(questions);
    if (maintick::isSlowWithManyBounces(run)) {
        std::get<probe::TraceQuestion>(questions[maintick::kDeep]).rays.pop_back();
        run = examinee.ask(questions);
    }
    if (auto end = maintick::checkMirrorEnd(run)) {
        findings = {*std::move(end)};
        return std::nullopt;
    }
    if (!findings.empty()) return std::nullopt;
    if (auto blocked = judgeUnanswered(run, "Renderer::trace")) return blocked;
    auto wrong = checkLit(facing, run);
    if (!wrong) wrong = checkDeep(deep, run);
    if (!wrong) wrong = checkGrazed(grazed, run);
    if (!wrong)
        wrong = maintick::checkMixedMirrors(mixed, std::span{run.answers}.subspan(kBeforeMixed));
    if (wrong) findings.push_back(*std::move(wrong));
    return std::nullopt;
}

TaskJudgement judgeBy(const MirrorPlan& plan, probe::Examinee& examinee, std::uint64_t seed) {
    const MirrorQuestion& open = plan.open;
    const probe::Run first = examinee.ask({open.direct, open.question});
    if (auto blocked = judgeUnanswered(first, "Renderer::trace")) return *std::move(blocked);
    const auto& direct = std::get<probe::IlluminateAnswer>(first.answers.at(0)).colours;
    const auto& answer = std::get<probe::IlluminateAnswer>(first.answers.at(1));
    std::vector<Finding> findings;
    if (auto wrong = checkColours(open, direct, answer)) findings.push_back(*std::move(wrong));
    if (findings.empty() || is(findings.front(), kMirrorEndless))
        if (auto blocked = askMore(plan, examinee, findings)) return *std::move(blocked);
    if (findings.empty())
        if (auto mixed = maintick::checkThreads(examinee, seed, maintick::Shows::mirrors,
                                                kMirrorThreadsMixed))
            findings.push_back(*std::move(mixed));
    return judgementOf(std::move(findings), kMirrorFindings);
}

}  // namespace

TaskJudgement judgeReflections(probe::Examinee& examinee, std::uint64_t seed) {
    return judgeBy(MirrorPlan{seed}, examinee, seed);
}

Judge judgeReflectionsOfMany() {
    return [plans = std::make_shared<Shelf<std::uint64_t, const MirrorPlan>>()](
               probe::Examinee& examinee, std::uint64_t seed) {
        return judgeBy(*plans->of(seed, seed), examinee, seed);
    };
}

}  // namespace ticker::tasks
