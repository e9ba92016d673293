#include <grader/tasks/maintick/JudgeMainTick.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/LitSetups.h>
#include <grader/tasks/maintick/Threads.h>
#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/RunEnd.h>
#include <grader/tasks/support/Shelf.h>

#include <fmt/core.h>

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <variant>

namespace ticker::tasks {
namespace {

using maintick::isNear;
using maintick::LitSetup;
using maintick::words;

/// The finding if no known mistake explains the answers, by the kind of the first wrong question.
/// The rows below are in the order of `LitKind`.
struct KindName {
    const FindingText* finding;
    const char* hint = "";  ///< empty: that of `finding`
};
constexpr std::array kNames{
    KindName{&kPhongAmbient},
    KindName{&kPhongDiffuse},
    KindName{&kPhongSpecular},
    KindName{&kPhongClamp},
    KindName{&kPhongLights},
    KindName{&kPhongRange},
    KindName{&kPhongFalloff},
    KindName{&kPhongWrong},
    KindName{&kPhongLights,
             "Few lights are right and twenty are not: every light of scene.pointLights() counts, "
             "however many there are. Leave out the limit of their number."},
    KindName{&kPhongSpecular,
             "Highlights of very shiny surfaces are wrong: hand object.phongAlpha() to std::pow as "
             "it is, however large, without a limit (as 128) and in no small type (as a byte)."},
    KindName{&kPhongLights, maintick::kFaintLight},
    KindName{&kPhongLights,
             "Lights of all channels are right, and one that has a single channel is not, or a "
             "surface that reflects nothing of it: red, green and blue count alike, and where the "
             "diffuse term is black there is the highlight all the same."}};

std::string askedOf(const LitSetup& setup) {
    std::string text =
        fmt::format("illuminate was asked about P = {} with N = {}, seen from O = {}",
                    words(setup.P), words(setup.N), words(setup.O));
    if (setup.scene.pointLights.empty()) return text + ", without any point light";
    text += ", lit from";
    for (const auto& light : setup.scene.pointLights)
        text += " " + words(light.position());
    return text;
}

std::optional<Finding> check(const std::vector<maintick::LitQuestion>& asked,
                             const std::vector<ColourRGB>& given) {
    const auto isRight = [&](std::size_t i, const maintick::PhongMistake* mistake) {
        return isNear(given[i], maintick::phong(asked[i].setup, mistake));
    };
    const auto first = maintick::firstWrong(given.size(), nullptr, isRight);
    if (!first) return std::nullopt;
    const LitSetup& setup = asked[*first].setup;
    const std::string seen = fmt::format("{}: expected {}, got {}.", askedOf(setup),
                                         words(maintick::phong(setup)), words(given[*first]));
    if (auto known = maintick::nameMistake(maintick::phongMistakes(), given.size(), isRight, seen))
        return known;
    const KindName& name = kNames.at(static_cast<std::size_t>(asked[*first].kind));
    return maintick::failure(*name.finding, seen, name.hint);
}

/// Shadows that the code casts already must not count here, so the points float away from every
/// surface. Code that casts its shadow rays from the light lights no such point; it is judged by
/// the same points on a surface.
std::optional<Finding> checkBoth(const std::vector<maintick::LitQuestion>& asked,
                                 const std::vector<ColourRGB>& floating,
                                 const std::vector<ColourRGB>& onSurface) {
    auto wrong = check(asked, floating);
    return wrong && wrong->id == kPhongUnlit.id ? check(asked, onSurface) : wrong;
}

/// The questions of one seed.
struct PhongPlan {
    explicit PhongPlan(std::uint64_t seed)
        : asked(maintick::drawLitQuestions(seed)), mixed(maintick::drawMixedPoints(seed)) {}
    std::vector<maintick::LitQuestion> asked;
    std::vector<maintick::MixedPoint> mixed;
};

TaskJudgement judgeBy(const PhongPlan& plan, probe::Examinee& examinee, std::uint64_t seed) {
    const auto& [asked, mixed] = plan;
    std::vector<probe::Question> questions;
    for (const maintick::LitQuestion& one : asked)
        questions.emplace_back(maintick::questionOf(one.setup));
    for (const maintick::LitQuestion& one : asked)
        questions.emplace_back(maintick::questionOf(maintick::onItsSurface(one.setup)));
    maintick::askMixedPoints(mixed, questions);
    const probe::Run run = examinee.ask(questions);
    if (auto blocked = judgeUnanswered(run, "Renderer::illuminate")) return *std::move(blocked);
    const std::span<const probe::Answer> answers{run.answers};
    std::vector<ColourRGB> floating;
    std::vector<ColourRGB> onSurface;
    for (const probe::Answer& answer : answers.first(2 * asked.size()))
        (floating.size() < asked.size() ? floating : onSurface)
            .push_back(std::get<probe::IlluminateAnswer>(answer).colours.at(0));
    std::vector<Finding> findings;
    auto wrong = checkBoth(asked, floating, onSurface);
    if (!wrong) wrong = maintick::checkMixedPoints(mixed, answers.subspan(2 * asked.size()));
    if (!wrong)
        wrong = maintick::checkThreads(examinee, seed, maintick::Shows::floor, kPhongThreadsMixed);
    if (wrong) findings.push_back(*std::move(wrong));
    return judgementOf(std::move(findings), kPhongFindings);
}

}  // namespace

TaskJudgement judgePhong(probe::Examinee& examinee, std::uint64_t seed) {
    return judgeBy(PhongPlan{seed}, examinee, seed);
}

Judge judgePhongOfMany() {
    return [plans = std::make_shared<Shelf<std::uint64_t, const PhongPlan>>()](
               probe::Examinee& examinee, std::uint64_t seed) {
        return judgeBy(*plans->of(seed, seed), examinee, seed);
    };
}

}  // namespace ticker::tasks
