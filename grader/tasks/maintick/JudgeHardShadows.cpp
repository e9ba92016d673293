#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/ShadeCases.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tasks/support/Shelf.h>

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using maintick::isNear;
using maintick::LitSetup;
using maintick::Occluder;
using maintick::RayStart;
using maintick::ShadeCase;
using maintick::ShadeSeen;
using maintick::Shown;
using raytracer::Vector3;

using Seen = std::vector<ShadeSeen>;
constexpr std::size_t kQuestionsEach = 7;

/// The question about the setup's point on its own object.
probe::IlluminateQuestion onSurface(const ShadeCase& shade, const LitSetup& setup) {
    probe::IlluminateQuestion question = maintick::questionOf(setup);
    question.points[0].object = shade.object;
    return question;
}

probe::IlluminateQuestion askedOf(const ShadeCase& shade) {
    probe::IlluminateQuestion question = onSurface(shade, shade.asked);
    question.eventCapacity = 32;
    return question;
}

probe::IlluminateQuestion freeWith(const ShadeCase& shade, double kd, double ks) {
    LitSetup setup = shade.free;
    const auto scale = [&](raytracer::Material& material) {
        material.phongKD *= kd;
        material.phongKS *= ks;
    };
    for (auto& sphere : setup.scene.spheres)
        scale(sphere.material);
    for (auto& plane : setup.scene.planes)
        scale(plane.material);
    return onSurface(shade, setup);
}

RayStart rayStartOf(const Vector3& origin, const LitSetup& asked) {
    constexpr double kNear = 0.3;
    constexpr double kAside = 0.01;
    const Vector3 offset = origin - asked.P;
    if (offset.magnitude() < kNear) return RayStart::nearPoint;
    for (const raytracer::PointLight& light : asked.scene.pointLights)
        if ((origin - light.position()).magnitude() < kNear) return RayStart::nearLight;
    return offset.cross(asked.N).magnitude() < kAside * offset.magnitude() ? RayStart::alongNormal
                                                                           : RayStart::elsewhere;
}

/// Sets `bias`, `aim` and `start` from the logged shadow rays. A ray from the light to the point is
/// right as well.
void readRays(ShadeSeen& seen, const std::vector<probe::Event>& events) {
    const LitSetup& asked = seen.asked->asked;
    for (const probe::Event& event : events) {
        if (event.kind != probe::Event::Kind::rayCast) continue;
        const RayStart start = rayStartOf(event.a, asked);
        seen.start = std::min(seen.start, start);
        if (start != RayStart::nearPoint) continue;
        seen.bias = std::max(seen.bias, (event.a - asked.P).magnitude());
        for (const raytracer::PointLight& light : asked.scene.pointLights) {
            const Vector3 L = (light.position() - asked.P).normalised();
            const double cosine = L.dot(event.b.normalised());
            if (!seen.aim || cosine > *seen.aim) seen.aim = cosine;
        }
    }
}

/// Sets `isUnlit` for cases in which grazing light is lost. If any other light is lost, too, that
/// is a mistake of M2, and no case is marked.
void findUnlit(Seen& seen) {
    const auto isOf = [](const ShadeSeen& one) { return one.asked->place == Occluder::grazing; };
    if (std::any_of(seen.begin(), seen.end(),
                    [&](const ShadeSeen& one) { return !isOf(one) && one.hasNoLight(); }))
        return;
    for (ShadeSeen& one : seen)
        one.isUnlit = isOf(one) && one.hasNoLight();
}

Seen readAnswers(const std::vector<ShadeCase>& cases, const probe::Run& run) {
    Seen seen;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto answer = [&](std::size_t k) -> const probe::IlluminateAnswer& {
            return std::get<probe::IlluminateAnswer>(run.answers.at(kQuestionsEach * i + k));
        };
        const auto colour = [&](std::size_t k) { return answer(k).colours.at(0); };
        ShadeSeen one{&cases[i], colour(0), colour(1), colour(2), colour(3), colour(4), colour(5)};
        // In code that casts its shadow rays from the light every floating point is hidden, since
        // no ray hits it. The same point on its surface then shows what full light is.
        if (one.hasNoLight()) one.lit = colour(6);
        readRays(one, answer(0).events);
        seen.push_back(one);
    }
    findUnlit(seen);
    return seen;
}

const ShadeSeen* firstThat(const Seen& seen, auto&& fits) {
    const auto found = std::find_if(seen.begin(), seen.end(), fits);
    return found == seen.end() ? nullptr : &*found;
}

std::string describe(const ShadeSeen& seen) {
    if (seen.isUnlit)
        return fmt::format(
            "illuminate was asked about P = {}, where {}: expected more than without the "
            "light, got the same, {}.",
            maintick::words(seen.asked->asked.P), wordsOf(seen.asked->place),
            maintick::words(seen.given));
    return fmt::format("illuminate was asked about P = {}, where {}: expected {}, got {}.",
                       maintick::words(seen.asked->asked.P), wordsOf(seen.asked->place),
                       maintick::words(seen.expected()), maintick::words(seen.given));
}

std::optional<Finding> check(const Seen& seen) {
    if (firstThat(seen, [](const ShadeSeen& one) { return !isNear(one.lit, one.dark); }) ==
        nullptr) {
        const ShadeSeen* lit =
            firstThat(seen, [](const ShadeSeen& one) { return !isNear(one.given, one.dark); });
        if (lit != nullptr) return maintick::failure(kShadeInverted, describe(*lit));
        return maintick::failure(kShadeNoLight,
                                 "A point was asked about with a light that nothing hides, and "
                                 "without any light: the colours are the same.");
    }
    const ShadeSeen* first =
        firstThat(seen, [](const ShadeSeen& one) { return one.shown() != Shown::right; });
    if (first != nullptr) {
        auto [text, hint] = nameOf(seen, *first);
        if (text == &kShadeAcne)
            first = firstThat(seen, [](const ShadeSeen& one) {
                return one.asked->place == Occluder::itself && one.shown() != Shown::right;
            });
        return maintick::failure(*text, describe(*first), std::move(hint));
    }
    constexpr double kLargestBias = 1.1e-3;
    const ShadeSeen* far =
        firstThat(seen, [](const ShadeSeen& one) { return one.bias > kLargestBias; });
    if (far == nullptr) return std::nullopt;
    return maintick::failure(
        kShadeBias, fmt::format("A shadow ray was expected to start at most 0.001 from the point; "
                                "it starts {:.3g} away.",
                                far->bias));
}

/// The questions of one seed.
struct ShadePlan {
    explicit ShadePlan(std::uint64_t seed)
        : cases(maintick::drawShadeCases(seed)), mixed(maintick::drawMixedShades(seed)) {}
    std::vector<ShadeCase> cases;
    std::vector<maintick::MixedShade> mixed;
};

TaskJudgement judgeBy(const ShadePlan& plan, probe::Examinee& examinee, std::uint64_t seed) {
    const auto& [cases, mixed] = plan;
    std::vector<probe::Question> questions;
    for (const ShadeCase& shade : cases) {
        questions.emplace_back(askedOf(shade));
        questions.emplace_back(maintick::questionOf(shade.floating));
        questions.emplace_back(onSurface(shade, shade.without));
        questions.emplace_back(onSurface(shade, shade.putOut));
        questions.emplace_back(freeWith(shade, 0.0, 1.0));
        questions.emplace_back(freeWith(shade, 1.0, 0.0));
        questions.emplace_back(onSurface(shade, shade.free));
    }
    maintick::askMixedShades(mixed, questions);
    const probe::Run run = examinee.ask(questions);
    if (auto blocked = judgeUnanswered(run, "Renderer::illuminate")) return *std::move(blocked);
    std::vector<Finding> findings;
    auto wrong = check(readAnswers(cases, run));
    if (!wrong)
        wrong = maintick::checkMixedShades(
            mixed, std::span{run.answers}.subspan(kQuestionsEach * cases.size()));
    if (!wrong)
        wrong =
            maintick::checkThreads(examinee, seed, maintick::Shows::shadows, kShadeThreadsMixed);
    if (wrong) findings.push_back(*std::move(wrong));
    return judgementOf(std::move(findings), kShadeFindings);
}

}  // namespace

TaskJudgement judgeHardShadows(probe::Examinee& examinee, std::uint64_t seed) {
    return judgeBy(ShadePlan{seed}, examinee, seed);
}

Judge judgeHardShadowsOfMany() {
    return [plans = std::make_shared<Shelf<std::uint64_t, const ShadePlan>>()](
               probe::Examinee& examinee, std::uint64_t seed) {
        return judgeBy(*plans->of(seed, seed), examinee, seed);
    };
}

}  // namespace ticker::tasks
