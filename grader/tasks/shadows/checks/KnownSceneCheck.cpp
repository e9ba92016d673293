#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>

namespace ticker::tasks {
namespace {

using Logs = std::vector<const ShadowLog*>;

struct KnownScene {
    Logs ShadowLogs::*logs;
    const FindingText* text;
    const char* seen;
    const char* hint;
};

constexpr std::array kKnownScenes{
    KnownScene{&ShadowLogs::oneTerm, &kShadowWrong,
               "Where a surface reflects none of the light but its highlight (it is black, or has "
               "another colour, or phongKD() is 0), or has no highlight (phongKS() is 0), the "
               "other term was expected as it is; the colour is another one.",
               "Neither term depends on whether the other one is 0: leave a light out only where "
               "it is behind the surface, max(0, N.L) = 0, not where its diffuse term is black."},
    KnownScene{&ShadowLogs::mirror, &kShadowWrong,
               "A surface of reflectivity 1 was expected to be lit like every other one; its "
               "colour is another one.",
               "illuminate knows nothing of mirrors: trace multiplies by 1 - reflectivity() where "
               "a ray is mirrored, and shows the whole colour where no bounce is left. Leave "
               "reflectivity() out of illuminate."},
    KnownScene{&ShadowLogs::enclosed, &kShadowWrong,
               "Where a ball has the light inside, or the point, the ball was expected to hide the "
               "light; the colour is another one.",
               "Whatever the ray meets before the target hides it, whichever side of the surface "
               "it meets: do not compare the hit's normal with the ray, and leave no object out."},
    KnownScene{&ShadowLogs::betweenLights, &kShadowLightsMixed,
               "Where an object stands before one light and behind another, it was expected to "
               "hide the first one alone; the colour is another one.",
               "What hides one light decides nothing for the next: ask "
               "scene.findClosestIntersection for every ray to every light, compare its distance "
               "with that of the target each time, and remember no object and no answer."},
};

constexpr KnownScene kLightsInLine{
    &ShadowLogs::lightsInLine, &kShadowLightsMixed,
    "Where one light stands behind another in the same direction, both were expected to arrive in "
    "full; the colour is another one.",
    "Lights are no objects and hide nothing: a ray ends at its own light, and only "
    "scene.findClosestIntersection says what is in its way."};

Finding findingFor(const KnownScene& scene) {
    Finding finding = distributedFinding(*scene.text, Severity::fail, scene.seen);
    finding.hint = scene.hint;
    finding.section = "Soft shadows (T2.1), step 3";
    return finding;
}

bool isDark(const ShadowLog& log) {
    constexpr double kSlack = 0.02;
    return std::ranges::all_of(log.points, [&](const PointLog& point) {
        const ColourRGB ambient = ambientPart(point, log.scene());
        return near(point.colour, ambient, ambient * kSlack);
    });
}

/// Whether a light behind the surface adds light only after a light in front. Code that lights the
/// back of surfaces anyway, as limits against shadow acne may, is not blamed for this.
bool keepsShare(const ShadowLogs& logs, const ShadowReading& reading) {
    const auto dark = [](const ShadowLog* log) { return isDark(*log); };
    return std::ranges::all_of(logs.behindAlone, dark) &&
           !allNearKnown(logs.behindAfter, reading.viewerIsEye);
}

Finding shareKept() {
    Finding finding = distributedFinding(
        kShadowLightsMixed, Severity::fail,
        "A light behind the surface was expected to add nothing, and does so alone; after a light "
        "in front it adds a highlight.");
    finding.hint =
        "The share of one light may not be used for the next: declare it inside of the loop over "
        "the lights, and go on with the next light (continue) where N.L is not above 0.";
    finding.section = "Soft shadows (T2.1), step 3";
    return finding;
}

/// Whether more rays are cast where more are asked for.
bool followsCount(const ShadowLogs& logs, const ShadowReading& reading, bool raysSeen) {
    if (!raysSeen) return allNearKnown(logs.otherSettings, reading.viewerIsEye);
    return countRays(logs.otherSettings).fewest > countRays(logs.oneLight).fewest;
}

}  // namespace

std::optional<Finding> checkKnownScenes(const ShadowLogs& logs, const ShadowReading& reading,
                                        bool raysSeen) {
    // Both tests are needed: a reading fits any colour of a point without rays, and geometry tells
    // the colours of such points only approximately.
    const auto fits = [&](const ShadowLog* log) {
        return allNearKnown({log}, reading.viewerIsEye) && (!raysSeen || fitsAnyReading(*log));
    };
    // Rays to lights in one direction cannot be told apart, so that geometry alone decides.
    if (!allNearKnown(logs.lightsInLine, reading.viewerIsEye)) return findingFor(kLightsInLine);
    for (const KnownScene& scene : kKnownScenes)
        if (!std::ranges::all_of(logs.*scene.logs, fits)) return findingFor(scene);
    if (keepsShare(logs, reading)) return shareKept();
    return std::nullopt;
}

std::optional<Finding> checkManyRays(const ShadowLogs& logs, const ShadowReading& reading,
                                     bool raysSeen) {
    if (!followsCount(logs, reading, raysSeen)) return std::nullopt;
    for (const ShadowLog* log : logs.manyRays) {
        const auto asked = static_cast<std::size_t>(log->settings().shadowRayCount);
        const std::size_t fewest = raysSeen ? countRays({log}).fewest : asked;
        const bool isRight =
            raysSeen ? fitsAnyReading(*log) : allNearKnown({log}, reading.viewerIsEye);
        if (fewest >= asked && isRight) continue;
        Finding finding = distributedFinding(
            fewest < asked ? kShadowTooFewRays : kShadowWrong, Severity::fail,
            fmt::format("With few rays all is right; asked for {}, illuminate {}.", asked,
                        fewest < asked ? fmt::format("casts {}", fewest)
                                       : "gives the light another share than that of the rays "
                                         "that arrive"));
        finding.hint =
            fewest < asked
                ? "Take out what limits the number of rays: an array of a fixed size, std::min, or "
                  "a small type for a count."
                : "Divide the number of rays that arrive, as double, by the number that you cast: "
                  "neither a share in whole percent nor a small type for a count, as std::uint8_t, "
                  "which begins again at 0 after 255.";
        finding.section = "Soft shadows (T2.1), step 1";
        finding.evidence.emplace_back("raysAsked", static_cast<double>(asked));
        finding.evidence.emplace_back("raysSeen", static_cast<double>(fewest));
        return finding;
    }
    return std::nullopt;
}

}  // namespace ticker::tasks
