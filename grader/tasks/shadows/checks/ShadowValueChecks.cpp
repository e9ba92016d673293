#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tasks/shadows/checks/HighlightCheck.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

using Logs = std::vector<const ShadowLog*>;

PhongTerms termsTowards(const PointLog& point, const raytracer::SceneDescription& scene) {
    const raytracer::PointLight& light = scene.pointLights[0];
    const Vector3 towards = light.position() - point.point.position;
    const double distance = towards.magnitude();
    return phongTerms(materialOf(scene, point.point.object), light, point.point.normal,
                      (point.point.viewer - point.point.position).normalised(), towards / distance,
                      distance);
}

// Whether points in the shadow of their only light have this share of its diffuse and specular
// terms, and of the ambient term.
bool shadowHolds(const Logs& logs, double ambient, bool diffuse, bool specular) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            if (point.zones[0] != Zone::umbra) continue;
            const PhongTerms terms = termsTowards(point, log->scene());
            ColourRGB expected = ambientPart(point, log->scene()) * ambient;
            if (diffuse) expected += terms.diffuse;
            if (specular) expected += terms.specular;
            if (!near(point.colour, expected, inFullLight(point, log->scene()) * 0.1)) return false;
        }
    return true;
}

// Whether points in full light are lit.
bool litWhereItShould(const Logs& logs) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            if (point.zones[0] == Zone::lit && !isNearKnown(point, *log, false)) return false;
    return true;
}

// Whether some light arrives although an object stands behind the light: an object behind the
// centre would stop all rays.
bool isPartlyLit(const Logs& logs) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            if (point.zones[0] != Zone::lit) continue;
            const ColourRGB light = inFullLight(point, log->scene());
            if (!near(point.colour, ambientPart(point, log->scene()), light * 0.1)) return true;
        }
    return false;
}

Finding darkBeyond(const Logs& logs) {
    Finding finding = distributedFinding(
        kShadowBeyondLight, Severity::fail,
        "A point in plain sight of the light was expected to be lit; an object behind the light "
        "casts a shadow on it.");
    if (!isPartlyLit(logs)) return finding;
    finding.message =
        "A point in plain sight of the light was expected to be lit in full; objects behind the "
        "light, or beside it, take a part of its light away.";
    finding.hint +=
        " Or shadow rays go past the light: none may aim farther than lightSize from its centre.";
    return finding;
}

// Whether all values are right once the ambient light of all lights but one is subtracted.
bool ambientIsThereForEachLight(const Logs& logs) {
    for (const ShadowLog* log : logs)
        for (PointLog point : log->points) {
            const auto lights = static_cast<double>(log->scene().pointLights.size());
            point.colour = point.colour - ambientPart(point, log->scene()) * (lights - 1.0);
            if (!isNearKnown(point, *log, false)) return false;
        }
    return true;
}

// Whether all values are right for a scene in which only one of the spheres casts a shadow.
bool oneSphereCasts(const Logs& logs) {
    const auto castsAlone = [](const ShadowLog& log, std::size_t sphere) {
        raytracer::SceneDescription alone = log.scene();
        alone.spheres = {log.scene().spheres[sphere]};
        const Surfaces surfaces{alone};
        return std::ranges::all_of(log.points, [&](PointLog point) {
            point.zones = zonesOf(alone, surfaces, point.point.position, point.point.normal,
                                  log.settings().lightSize);
            return isNearKnown(point, log, false);
        });
    };
    return std::ranges::all_of(logs, [&](const ShadowLog* log) {
        for (std::size_t i = 0; i < log->scene().spheres.size(); ++i)
            if (castsAlone(*log, i)) return true;
        return false;
    });
}

// Without rays, the light that is left in full shadow shows the mistake.
std::optional<Finding> knownValueMistake(const ShadowLogs& logs) {
    if (allNearKnown(logs.oneLight, false)) {
        if (!allNearKnown(logs.beyondLight, false)) return darkBeyond(logs.beyondLight);
        if (!allNearKnown(logs.lowLight, false))
            if (auto highlight = highlightOfLowLight(logs.lowLight)) return highlight;
        if (!allNearKnown(logs.severalLights, false)) {
            if (ambientIsThereForEachLight(logs.severalLights)) return ambientForEachLight();
            if (oneSphereCasts(logs.severalLights)) return oneObjectCasts();
            return distributedFinding(kShadowLightsMixed, Severity::fail,
                                      "With one light the colours are right; with several lights "
                                      "they are not.");
        }
        if (!allNearKnown(logs.planeShadow, false)) return planesCastNothing();
        if (!allNearKnown(logs.lightBehind, false)) return lightsLostBehind();
        if (!allNearKnown(logs.inLine, false)) return hitsMistaken();
        if (!allNearKnown(logs.nearLight, false)) return nearLightMissed();
        if (!allNearKnown(logs.farLight, false))
            return distributedFinding(
                kShadowWrong, Severity::fail,
                "With a light some six units away the colours are right; with one more than a "
                "hundred units away they are not.");
        if (!allNearKnown(logs.pureColours, false)) return channelsLost();
        return std::nullopt;
    }
    if (shadowHolds(logs.oneLight, 0.0, false, false))
        return findingOf(ShadowArithmetic::ambientScaled);
    if (shadowHolds(logs.oneLight, 1.0, false, true))
        return findingOf(ShadowArithmetic::specularUnshadowed);
    if (shadowHolds(logs.oneLight, 1.0, true, false))
        return findingOf(ShadowArithmetic::diffuseUnshadowed);
    if (!shadowHolds(logs.oneLight, 1.0, true, true)) return std::nullopt;
    if (!litWhereItShould(logs.oneLight)) return findingOf(ShadowArithmetic::inverted);
    return distributedFinding(kShadowWrong, Severity::fail,
                              "Points in full shadow were expected to have ambient light alone; "
                              "nothing ever casts a shadow.");
}

double sumOf(const ColourRGB& colour) {
    return colour.r + colour.g + colour.b;
}

// Words for the share of light in full light and in full shadow; empty if the numbers would not
// help.
std::string sharesSeen(const Logs& logs) {
    constexpr double kEven = 0.02;
    std::map<Zone, std::pair<double, double>> seen;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            const ColourRGB ambient = ambientPart(point, log->scene());
            const double share =
                sumOf(point.colour - ambient) / sumOf(inFullLight(point, log->scene()) - ambient);
            auto& [least, most] = seen.try_emplace(point.zones[0], share, share).first->second;
            least = std::min(least, share);
            most = std::max(most, share);
        }
    if (seen.count(Zone::lit) == 0 || seen.count(Zone::umbra) == 0) return {};
    for (const Zone zone : {Zone::lit, Zone::umbra})
        if (!(seen[zone].second - seen[zone].first < kEven)) return {};
    const auto near = [&](Zone zone, double share) {
        return std::abs(seen[zone].first - share) < kEven;
    };
    if (near(Zone::lit, 1.0) && near(Zone::umbra, 0.0)) return {};
    return fmt::format(
        ": {:.2g} of the light where all of it is in sight (1 was expected), {:.2g} "
        "in full shadow (0 was expected)",
        seen[Zone::lit].first, std::max(0.0, seen[Zone::umbra].first));
}

}  // namespace

ArithmeticVerdict checkValues(const ShadowLogs& logs) {
    ArithmeticVerdict verdict;
    for (const bool viewerIsEye : {false, true}) {
        if (!allNearKnown(logs.atHandoutSettings(), viewerIsEye)) continue;
        verdict.reading = ShadowReading{ShadowReading::Phong::central, viewerIsEye, false, {}};
        return verdict;
    }
    verdict.finding = knownValueMistake(logs);
    if (!verdict.finding) verdict.finding = highlightAlone(logs.oneLight);
    if (!verdict.finding)
        verdict.finding = distributedFinding(
            kShadowWrong, Severity::fail,
            "Points in full light and in full shadow have a known colour; illuminate gives "
            "another one" +
                sharesSeen(logs.oneLight) + '.');
    return verdict;
}

}  // namespace ticker::tasks
