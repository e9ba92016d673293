#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/maintick/MirrorQuestions.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/support/RunEnd.h>

#include <fmt/core.h>

#include <array>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using maintick::isNear;
using maintick::MirrorQuestion;
using maintick::TraceMistake;
using maintick::words;

struct NamedTraceMistake {
    TraceMistake mistake;
    const FindingText* finding;
    const char* hint = "";
};

constexpr std::array kTraceMistakes{
    NamedTraceMistake{TraceMistake::black, &kMirrorBackground},
    NamedTraceMistake{TraceMistake::blackMirrored, &kMirrorBackground},
    NamedTraceMistake{
        TraceMistake::directWhereMirroredMisses, &kMirrorBackground,
        "A mirrored ray that meets nothing shows the background: blend with it as well."},
    NamedTraceMistake{
        TraceMistake::notNegated, &kMirrorDirection,
        "The minus is missing: reflectIn mirrors what points away from the surface, and "
        "ray.direction points at it: (-ray.direction).reflectIn(N)."},
    NamedTraceMistake{TraceMistake::straightOn, &kMirrorDirection,
                      "The ray goes straight on through the surface: mirror it, "
                      "(-ray.direction).reflectIn(N)."},
    NamedTraceMistake{
        TraceMistake::straightBack, &kMirrorDirection,
        "The ray goes back the way it came: mirror it, (-ray.direction).reflectIn(N)."},
    NamedTraceMistake{TraceMistake::alongNormal, &kMirrorDirection,
                      "The ray leaves along the normal: mirror the direction in it, "
                      "(-ray.direction).reflectIn(N)."},
    NamedTraceMistake{
        TraceMistake::startAtOrigin, &kMirrorStart,
        "The mirrored ray starts where the first one did: start it at P + N * kShadowBias."},
    NamedTraceMistake{TraceMistake::startBelow, &kMirrorStart,
                      "The mirrored ray starts below the surface: P + N * kShadowBias, not minus."},
    NamedTraceMistake{TraceMistake::notLowered, &kMirrorEndless},
    NamedTraceMistake{
        TraceMistake::oneLess, &kMirrorBounces,
        "One bounce too few is followed: the recursion ends at bouncesLeft == 0, not at 1, "
        "and each call hands on bouncesLeft - 1."},
    NamedTraceMistake{TraceMistake::oneMore, &kMirrorBounces,
                      "One bounce too many is followed: the recursion ends at bouncesLeft == 0."},
    NamedTraceMistake{
        TraceMistake::once, &kMirrorBounces,
        "Mirrors in mirrors show nothing: follow the mirrored ray with trace itself, with "
        "bouncesLeft - 1."},
    NamedTraceMistake{
        TraceMistake::plusWhole, &kMirrorBlend,
        "Both colours are added whole: direct * (1 - rho) + reflected * rho, with rho = "
        "object.reflectivity()."},
    NamedTraceMistake{
        TraceMistake::sharesExchanged, &kMirrorBlend,
        "The shares are exchanged: rho belongs to the reflected colour, 1 - rho to the "
        "direct one."},
    NamedTraceMistake{TraceMistake::wholeDirect, &kMirrorBlend,
                      "The direct colour counts whole: multiply it by 1 - rho."},
    NamedTraceMistake{TraceMistake::wholeMirrored, &kMirrorBlend,
                      "The reflected colour counts whole: multiply it by rho."},
    NamedTraceMistake{TraceMistake::directLost, &kMirrorBlend,
                      "The direct colour is lost: add direct * (1 - rho)."},
    NamedTraceMistake{TraceMistake::mirroredAlone, &kMirrorBlend},
    NamedTraceMistake{TraceMistake::evenShares, &kMirrorBlend},
    NamedTraceMistake{TraceMistake::timesColour, &kMirrorBlend,
                      "A mirror does not tint what it shows: leave object.colour() out."},
    NamedTraceMistake{
        TraceMistake::baseReduced, &kMirrorBase,
        "Where no bounce is left the direct colour counts whole: return it before it is "
        "multiplied by 1 - rho."},
    NamedTraceMistake{
        TraceMistake::weakIgnored, &kMirrorNone,
        "Weak mirrors are left out: return the direct light alone only where rho is 0."},
    NamedTraceMistake{TraceMistake::weightReplaced, &kMirrorBlend,
                      "From the second mirror on the shares of those before it are lost. In a loop "
                      "the weight is multiplied: weight *= rho."},
};

std::string askedOf(const MirrorQuestion& asked, std::size_t ray) {
    const probe::CastRay& cast = asked.question.rays[ray];
    return fmt::format(
        "trace was asked along the ray from {} in direction {} with {} bounce{} left",
        words(cast.origin), words(cast.direction), cast.bounces, cast.bounces == 1 ? "" : "s");
}

ColourRGB expected(const MirrorQuestion& asked, const std::vector<ColourRGB>& direct,
                   std::size_t ray, TraceMistake mistake) {
    const probe::CastRay& cast = asked.question.rays[ray];
    return maintick::TraceModel{asked.question.scene, direct, mistake}.along(
        {cast.origin, cast.direction}, cast.bounces);
}

/// How far the ray that follows the first one starts from the first hit; the direction is right.
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

/// Rays that leave into the surface, or from below it, see nothing but that surface: its colour is
/// that of no mirror at all. The ray that was cast tells them apart.
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
    const auto explains = [&](TraceMistake mistake) {
        for (std::size_t i = 0; i < given.size(); ++i)
            if (!isNear(given[i], expected(asked, direct, i, mistake))) return false;
        return true;
    };
    if (explains(TraceMistake::none)) return checkStarts(asked, answer, false);
    std::size_t first = 0;
    while (isNear(given[first], expected(asked, direct, first, TraceMistake::none)))
        ++first;
    const std::string seen =
        fmt::format("{}: expected {}, got {}.", askedOf(asked, first),
                    words(expected(asked, direct, first, TraceMistake::none)), words(given[first]));
    if (explains(TraceMistake::noMirror)) {
        const auto [text, hint] = whyOnlyItself(asked, answer);
        return maintick::failure(*text, seen, hint);
    }
    for (const NamedTraceMistake& named : kTraceMistakes)
        if (explains(named.mistake)) return maintick::failure(*named.finding, seen, named.hint);
    if (auto start = checkStarts(asked, answer, true)) return start;
    const bool isBase = asked.question.rays[first].bounces == 0;
    return maintick::failure(isBase ? kMirrorBase : kMirrorWrong, seen);
}

/// Two mirrors that face each other, in the light.
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
            "Colours above 1 are not cut off. The light of each surface is illuminate(scene, "
            "object, P, N, ray.origin): the viewer "
            "is "
            "where this ray starts, behind a mirror, too.");
    }
    return std::nullopt;
}

std::optional<Finding> checkEnd(const probe::Run& run) {
    using Kind = probe::ProcessEnd::Kind;
    if (run.end.kind != Kind::crashed && run.end.kind != Kind::timedOut &&
        run.end.kind != Kind::memory)
        return std::nullopt;
    return maintick::failure(kMirrorEndless,
                             "trace was asked about two mirrors that face each other, with at most "
                             "2 bounces left: it never came back.");
}

}  // namespace

TaskJudgement judgeReflections(probe::Examinee& examinee, std::uint64_t seed) {
    const MirrorQuestion open = maintick::drawOpenScene(seed);
    const probe::Run first = examinee.ask({open.direct, open.question});
    if (auto blocked = judgeUnanswered(first, "Renderer::trace")) return *std::move(blocked);
    const auto& direct = std::get<probe::IlluminateAnswer>(first.answers.at(0)).colours;
    const auto& answer = std::get<probe::IlluminateAnswer>(first.answers.at(1));
    std::vector<Finding> findings;
    if (auto wrong = checkColours(open, direct, answer)) findings.push_back(*std::move(wrong));
    if (findings.empty() || is(findings.front(), kMirrorEndless)) {
        const MirrorQuestion facing = maintick::drawFacingMirrors(seed);
        const probe::Run second = examinee.ask({facing.direct, facing.question});
        if (auto endless = checkEnd(second)) {
            findings = {*std::move(endless)};
        } else if (findings.empty()) {
            if (auto blocked = judgeUnanswered(second, "Renderer::trace"))
                return *std::move(blocked);
            if (auto wrong = checkLit(facing, second)) findings.push_back(*std::move(wrong));
        }
    }
    if (findings.empty())
        if (auto mixed = maintick::checkThreads(examinee, seed, maintick::Shows::mirrors,
                                                kMirrorThreadsMixed))
            findings.push_back(*std::move(mixed));
    return judgementOf(std::move(findings), kMirrorFindings);
}

}  // namespace ticker::tasks
