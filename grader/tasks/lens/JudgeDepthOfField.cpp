#include <grader/result/GeneralFindings.h>
#include <grader/tasks/lens/JudgeDepthOfField.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/answers/LensPlots.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/lens/questions/MixedRenders.h>
#include <grader/tasks/support/Checks.h>
#include <grader/tasks/support/FindingOrder.h>
#include <grader/tasks/support/Plots.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ticker::tasks {
namespace {

bool isFinite(const LensLog& log) {
    return std::all_of(log.pixels.begin(), log.pixels.end(), [](const LensPixel& pixel) {
        return std::isfinite(pixel.colour.r + pixel.colour.g + pixel.colour.b);
    });
}

// Every pixel of a picture shows light or the background: a black pixel was not set.
std::optional<Finding> checkComplete(const LensLog& log) {
    const auto unset = [](const LensPixel& pixel) {
        return pixel.rays.empty() && pixel.colour == ColourRGB{};
    };
    const auto first = std::find_if(log.pixels.begin(), log.pixels.end(), unset);
    const auto black = std::count_if(log.pixels.begin(), log.pixels.end(), unset);
    if (black == 0) return std::nullopt;
    Finding finding = distributedFinding(
        kDofWrong, Severity::fail,
        fmt::format("Every pixel was expected to be set; {} of {} have no ray and stay black, the "
                    "first in {}.",
                    black, log.pixels.size(), placeOf(log, first - log.pixels.begin())));
    finding.hint =
        "Set every pixel, all columns and all rows from 0 to the last: take out a return, or an "
        "end of a loop, that leaves some out.";
    return finding;
}

struct LensSeen {
    const LensLog& log;
    std::optional<double> apertureFactor = {};
};

using LensCheck = Check<LensSeen>;

std::optional<Finding> counts(LensSeen& seen) {
    return checkLensCounts(seen.log);
}

std::optional<Finding> aperture(LensSeen& seen) {
    ApertureVerdict verdict = checkAperture(seen.log);
    seen.apertureFactor = verdict.factor;
    return std::move(verdict.finding);
}

/// A new check of T2.2: a row here with its function, and a row in LensFindings.h.
const std::vector<LensCheck>& lensChecks() {
    static const std::vector<LensCheck> kChecks{
        {.run = counts},
        {.run = [](LensSeen& seen) { return checkAverage(seen.log); }},
        {.run = [](LensSeen& seen) { return checkBounces(seen.log); }},
        {.run = [](LensSeen& seen) { return checkFocus(seen.log); },
         .after = {{counts, &kDofNone}}},
        {.run = aperture, .after = {{counts, &kDofNone}, {counts, &kDofSharedSamples}}},
        {.run = [](LensSeen& seen) { return checkPattern(seen.log); },
         .after = {{counts, &kDofNone}, {counts, &kDofSharedSamples}}}};
    return kChecks;
}

// The first failure of a picture, for code that answered right under other conditions.
std::optional<Finding> firstFailure(const LensLog& log) {
    if (lacksRays(log)) return checkComplete(log);
    LensSeen seen{.log = log};
    const std::vector<Finding> findings = runChecks<LensSeen>(lensChecks(), seen);
    const auto wrong = std::ranges::find(findings, Severity::fail, &Finding::severity);
    if (wrong == findings.end()) return std::nullopt;
    return *wrong;
}

// `wrong` with the name of the condition that causes it.
Finding renamed(const FindingText& text, Severity severity, const std::string& condition,
                Finding wrong) {
    Finding finding = distributedFinding(text, severity, condition + wrong.message);
    if (finding.section.empty()) finding.section = "Depth of field (T2.2)";
    finding.evidence = std::move(wrong.evidence);
    finding.evidence.emplace_back("otherwise", wrong.id);
    return finding;
}

// `wrong`, if there is one, with this hint and a message that begins: under other conditions all
// is right.
// @param conditions  That sentence, up to "it is not".
std::optional<Finding> onlyWhere(const std::string& conditions, const char* hint,
                                 std::optional<Finding> wrong) {
    if (!wrong) return std::nullopt;
    wrong->message = conditions + " it is not. " + wrong->message;
    wrong->hint = hint;
    return wrong;
}

std::size_t fewestRays(const LensLog& log) {
    const auto fewest = std::ranges::min_element(
        log.pixels, {}, [](const LensPixel& pixel) { return pixel.rays.size(); });
    return fewest == log.pixels.end() ? 0 : fewest->rays.size();
}

std::optional<Finding> checkOtherSettings(const LensLog& log) {
    std::optional<Finding> wrong = firstFailure(log);
    if (!wrong) return std::nullopt;
    const auto handoutRays = static_cast<std::size_t>(raytracer::RenderSettings{}.dofRayCount);
    // Code with the handout's number hard-coded casts that many in every pixel: fewer rays have
    // another cause.
    if (is(*wrong, kDofTooFewRays) && !log.cut && fewestRays(log) < handoutRays)
        return onlyWhere("With the handout's settings all is right; with other settings",
                         "Cast settings().dofRayCount rays for every pixel, whatever the settings "
                         "are and whatever the pixel shows, also where that is sharp.",
                         std::move(wrong));
    Finding finding = renamed(kSettingsHardCoded, Severity::warn,
                              "render does not follow settings(): asked for other numbers than the "
                              "handout's, it is wrong. ",
                              *std::move(wrong));
    if (const std::size_t rays = fewestRays(log);
        rays > handoutRays && rays < static_cast<std::size_t>(log.asked->settings.dofRayCount))
        finding.message +=
            fmt::format(" The handout says {} rays; more are accepted.", handoutRays);
    return finding;
}

}  // namespace

bool isAntialiased(const std::vector<Finding>& findings) {
    return std::ranges::any_of(findings,
                               [](const Finding& finding) { return is(finding, kDofAntialiased); });
}

LensOutcome judgeDepthOfField(const LensLog& handout, const LensLog& other) {
    LensOutcome outcome;
    if (!isFinite(handout)) {
        outcome.findings.push_back(
            distributedFinding(kDofWrong, Severity::fail,
                               "Colours were expected; some pixels hold a value that is no "
                               "number."));
        return outcome;
    }
    if (std::optional<Finding> incomplete = checkComplete(handout);
        incomplete && handout.rayCount() > 0) {
        outcome.findings.push_back(*std::move(incomplete));
        return outcome;
    }
    if (std::optional<Finding> copies = checkCopies(handout)) {
        outcome.findings.push_back(*std::move(copies));
        return outcome;
    }
    outcome.rayless = lacksRays(handout);
    outcome.onlyExtra =
        outcome.rayless && std::ranges::none_of(handout.pixels, [](const LensPixel& pixel) {
            return pixel.rays.empty();
        });
    outcome.partly = outcome.rayless && !outcome.onlyExtra && handout.rayCount() > 0;
    outcome.cut = handout.cut;
    if (outcome.rayless) return outcome;
    outcome.valueless =
        handout.recomputed || !handout.pixels.front().rays.front().value.has_value();
    LensSeen seen{.log = handout};
    outcome.findings = runChecks<LensSeen>(lensChecks(), seen);
    outcome.apertureFactor = seen.apertureFactor;
    if (!hasFailure(outcome.findings))
        if (std::optional<Finding> finding = checkOtherSettings(other))
            outcome.findings.push_back(*std::move(finding));
    outcome.plots = unshown({plotLens(handout), plotFocus(handout)}, outcome.findings);
    return outcome;
}

// If fewer rays than asked for are cast, their number is not hard-coded, since more were cast at
// the handout's settings. If they are as many as the handout's, another check reports a hard-coded
// number.
std::optional<Finding> judgeOddCount(const LensLog& odd) {
    if (lacksRays(odd) || odd.cut) return std::nullopt;
    const auto asked = static_cast<std::size_t>(odd.asked->settings.dofRayCount);
    const auto handoutRays = static_cast<std::size_t>(raytracer::RenderSettings{}.dofRayCount);
    const std::size_t rays = fewestRays(odd);
    std::optional<Finding> wrong;
    if (rays < asked) wrong = checkLensCounts(odd);
    if (rays > asked && rays < handoutRays) wrong = checkAverage(odd);
    return onlyWhere(
        fmt::format("With {} rays for each pixel all is right; with an odd number", handoutRays),
        "Half of an odd number is rounded down as an int, so that rays in pairs are one too few; "
        "rounded up, they are one too many. So are other groups where some rays are left over. A "
        "loop that adds fractions up to 1 may run once too often. Cast settings().dofRayCount rays "
        "whatever that number is, or "
        "more, and divide their sum by the number of rays that you cast.",
        std::move(wrong));
}

std::optional<Finding> judgeManyRays(const LensLog& many, const LensLog& handout,
                                     const LensLog& other) {
    if (lacksRays(many) || many.cut || fewestRays(other) <= fewestRays(handout)) return {};
    const auto asked = static_cast<std::size_t>(many.asked->settings.dofRayCount);
    std::optional<Finding> wrong =
        fewestRays(many) < asked ? checkLensCounts(many) : checkAverage(many);
    return onlyWhere(
        fmt::format("With {} rays for each pixel all is right; with {}",
                    handout.asked->settings.dofRayCount, asked),
        "Take out what limits the number of rays: an array of a fixed size, std::min, or a small "
        "type for a count, as std::uint8_t, which begins again at 0 after 255.",
        std::move(wrong));
}

std::optional<Finding> judgeMixed(const LensLog& log) {
    // An empty scene, or one without light, looks the same with any number of rays, so that code
    // may cast none.
    const bool mayCastNone =
        log.asked->scene.planes.empty() || log.asked->scene.ambientLighting == ColourRGB{};
    if (lacksRays(log) && mayCastNone) return std::nullopt;
    std::optional<Finding> wrong = lacksRays(log) ? checkLensCounts(log) : firstFailure(log);
    return onlyWhere(
        fmt::format("In usual pictures all is right; {}", wordsOf(*log.asked)),
        "The formulas hold for every size of picture, focal plane, lens and scene: take out what "
        "limits one of them, and special cases for what a picture shows.",
        std::move(wrong));
}

std::optional<Finding> judgeAnotherScene(const LensLog& log) {
    std::optional<Finding> wrong = firstFailure(log);
    if (wrong)
        wrong->hint +=
            " Another scene was rendered rightly: look for what depends on what the scene shows, "
            "or on the picture's size, such as half an odd width as an int.";
    return wrong;
}

std::optional<Finding> judgeNextRender(const LensLog& log) {
    std::optional<Finding> wrong = firstFailure(log);
    if (!wrong) return std::nullopt;
    Finding finding = renamed(kDofWrong, Severity::fail,
                              "The first picture of a program is right; the next one of the same "
                              "size, through a camera of its own, keeps something of the first. ",
                              *std::move(wrong));
    finding.hint =
        "Nothing of one render may be kept for the next: camera, rays, focal points and sums are "
        "neither static nor thread_local nor global, and are made anew in every call of render.";
    finding.section = "Depth of field (T2.2), step 1";
    return finding;
}

std::optional<Finding> judgeWithThreads(const LensLog& log) {
    std::optional<Finding> wrong = firstFailure(log);
    if (!wrong) return std::nullopt;
    return renamed(kDofThreadsMixed, Severity::fail,
                   "With one thread all is right; with two, and forEachPixel has as many as the "
                   "machine has cores, it no longer is. ",
                   *std::move(wrong));
}

}  // namespace ticker::tasks
