#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/ShadeCases.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/support/RunEnd.h>

#include <fmt/core.h>

#include <limits>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using maintick::isNear;
using maintick::LitSetup;
using maintick::Occluder;
using maintick::ShadeCase;

/// What an answer equals, other than the right value.
enum class Shown : std::uint8_t { right, lit, dark, black, specular, diffuse, other };

/// What the same code gives with and without what stands around the point.
struct ShadeSeen {
    const ShadeCase* asked = nullptr;
    ColourRGB given;
    ColourRGB free;
    ColourRGB dark;
    ColourRGB putOut;    ///< dark as well, see ShadeCase
    ColourRGB specular;  ///< free, without diffuse light
    ColourRGB diffuse;   ///< free, without specular light
    double bias = 0.0;   ///< of the ray that starts farthest from the point; 0: none was seen

    [[nodiscard]] ColourRGB expected() const { return asked->isShaded() ? dark : free; }
    [[nodiscard]] Shown shown() const {
        const bool isDark = isNear(given, dark) || isNear(given, putOut);
        if (asked->isShaded() ? isDark : isNear(given, free)) return Shown::right;
        if (isNear(given, free)) return Shown::lit;
        if (isDark) return Shown::dark;
        if (isNear(given, ColourRGB{0.0})) return Shown::black;
        if (isNear(given, specular)) return Shown::specular;
        return isNear(given, diffuse) ? Shown::diffuse : Shown::other;
    }
};

using Seen = std::vector<ShadeSeen>;
constexpr std::size_t kQuestionsEach = 6;

probe::IlluminateQuestion askedOf(const ShadeCase& shade) {
    probe::IlluminateQuestion question = maintick::questionOf(shade.asked);
    question.points[0].object = shade.object;
    question.eventCapacity = 32;
    return question;
}

probe::IlluminateQuestion freeWith(const ShadeCase& shade, double kd, double ks) {
    LitSetup setup = shade.free;
    setup.scene.spheres[0].material.phongKD *= kd;
    setup.scene.spheres[0].material.phongKS *= ks;
    return maintick::questionOf(setup);
}

/// Rays that start at the light, and look at the point from there, are right as well.
double biasOf(const probe::IlluminateAnswer& answer, const Vector3& P) {
    constexpr double kNearPoint = 0.3;
    double farthest = 0.0;
    for (const probe::Event& event : answer.events) {
        const double away = (event.a - P).magnitude();
        if (event.kind == probe::Event::Kind::rayCast && away < kNearPoint)
            farthest = std::max(farthest, away);
    }
    return farthest;
}

Seen readAnswers(const std::vector<ShadeCase>& cases, const probe::Run& run) {
    Seen seen;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto answer = [&](std::size_t k) -> const probe::IlluminateAnswer& {
            return std::get<probe::IlluminateAnswer>(run.answers.at(kQuestionsEach * i + k));
        };
        const auto colour = [&](std::size_t k) { return answer(k).colours.at(0); };
        seen.push_back({&cases[i], colour(0), colour(1), colour(2), colour(3), colour(4), colour(5),
                        biasOf(answer(0), cases[i].asked.P)});
    }
    return seen;
}

std::string describe(const ShadeSeen& seen) {
    return fmt::format("illuminate was asked about P = {}, where {}: expected {}, got {}.",
                       maintick::words(seen.asked->asked.P), wordsOf(seen.asked->place),
                       maintick::words(seen.expected()), maintick::words(seen.given));
}

/// Of the cases that `belongs` picks: how many there are, and how many show `what`.
template <class Belongs>
bool allShow(const Seen& seen, Shown what, const Belongs& belongs) {
    bool any = false;
    for (const ShadeSeen& one : seen) {
        if (!belongs(*one.asked)) continue;
        any = true;
        if (one.shown() != what) return false;
    }
    return any;
}

bool allShow(const Seen& seen, Shown what, Occluder place) {
    return allShow(seen, what, [&](const ShadeCase& shade) { return shade.place == place; });
}

const ShadeSeen* firstThat(const Seen& seen, auto&& fits) {
    for (const ShadeSeen& one : seen)
        if (fits(one)) return &one;
    return nullptr;
}

/// The name of what is wrong at `first`, from what goes wrong elsewhere.
std::pair<const FindingText*, std::string> nameOf(const Seen& seen, const ShadeSeen& first) {
    const auto isShaded = [](const ShadeCase& shade) { return shade.isShaded(); };
    const auto isFree = [](const ShadeCase& shade) { return !shade.isShaded(); };
    const auto at = [&](Shown what, Occluder place) { return allShow(seen, what, place); };
    if (at(Shown::dark, Occluder::backwards) && at(Shown::lit, Occluder::before) &&
        !at(Shown::dark, Occluder::beyond))
        return {&kShadeWrong,
                "The ray leaves away from the light: its direction is (light.position() - "
                "P).normalised()."};
    if (allShow(seen, Shown::lit, isShaded)) {
        if (allShow(seen, Shown::dark, isFree)) return {&kShadeInverted, ""};
        if (at(Shown::dark, Occluder::beyond))
            return {&kShadeBeyond,
                    "The comparison is the wrong way round: a hit that is nearer than the light "
                    "shades."};
        return {&kShadeNone, ""};
    }
    const auto anyIs = [&](Shown what) {
        return firstThat(seen, [&](const ShadeSeen& one) {
                   return one.shown() == what && one.asked->place == first.asked->place;
               }) != nullptr;
    };
    if (at(Shown::right, Occluder::before) || at(Shown::right, Occluder::between)) {
        if (firstThat(seen, [](const ShadeSeen& one) {
                return one.asked->place == Occluder::itself && one.shown() != Shown::right;
            }) != nullptr)
            return {&kShadeAcne, ""};
        if (!at(Shown::right, Occluder::near) && at(Shown::right, Occluder::farBeyond) &&
            at(Shown::right, Occluder::between))
            return {&kShadeBias, ""};
        if (at(Shown::dark, Occluder::beyond) && at(Shown::right, Occluder::close))
            return {&kShadeBeyond, ""};
        for (const Occluder place : {Occluder::farBeyond, Occluder::close, Occluder::between})
            if (!at(Shown::right, place)) return {&kShadeDistance, ""};
        if (!at(Shown::right, Occluder::near)) return {&kShadeBias, ""};
        if (!at(Shown::right, Occluder::ofFirstLight) || !at(Shown::right, Occluder::ofSecondLight))
            return {&kShadeLights, ""};
        if (!at(Shown::right, Occluder::wall))
            return {&kShadeWrong,
                    "Planes cast shadows, too: whatever the ray meets before the light hides it."};
        if (!at(Shown::right, Occluder::beforeAndBeyond))
            return {&kShadeWrong,
                    "What stands behind the light decides nothing: look at the other objects, too, "
                    "or take the nearest hit, scene.findClosestIntersection(ray)."};
    }
    if (anyIs(Shown::black)) return {&kShadeAmbient, ""};
    if (anyIs(Shown::specular)) return {&kShadeSpecular, ""};
    if (anyIs(Shown::diffuse)) return {&kShadeDiffuse, ""};
    if (at(Shown::lit, Occluder::before))
        return {&kShadeWrong,
                "What is hidden comes out lit. Look at the direction of the ray, L, and at the "
                "comparison: a hit nearer than the light shades."};
    return {&kShadeWrong, ""};
}

std::optional<Finding> check(const Seen& seen) {
    if (firstThat(seen, [](const ShadeSeen& one) { return !isNear(one.free, one.dark); }) ==
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

}  // namespace

TaskJudgement judgeHardShadows(probe::Examinee& examinee, std::uint64_t seed) {
    const std::vector<ShadeCase> cases = maintick::drawShadeCases(seed);
    std::vector<probe::Question> questions;
    for (const ShadeCase& shade : cases) {
        questions.emplace_back(askedOf(shade));
        questions.emplace_back(freeWith(shade, 1.0, 1.0));
        questions.emplace_back(maintick::questionOf(shade.without));
        questions.emplace_back(maintick::questionOf(shade.putOut));
        questions.emplace_back(freeWith(shade, 0.0, 1.0));
        questions.emplace_back(freeWith(shade, 1.0, 0.0));
    }
    const probe::Run run = examinee.ask(questions);
    if (auto blocked = judgeUnanswered(run, "Renderer::illuminate")) return *std::move(blocked);
    std::vector<Finding> findings;
    auto wrong = check(readAnswers(cases, run));
    if (!wrong)
        wrong =
            maintick::checkThreads(examinee, seed, maintick::Shows::shadows, kShadeThreadsMixed);
    if (wrong) findings.push_back(*std::move(wrong));
    return judgementOf(std::move(findings), kShadeFindings);
}

}  // namespace ticker::tasks
