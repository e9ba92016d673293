#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/Phong.h>
#include <grader/decision/distributed/ShadowChecks.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ticker::decision {
namespace {

using Logs = std::vector<const ShadowLog*>;

bool allFit(const Logs& logs, const ShadowReading& reading, ShadowArithmetic arithmetic) {
    return std::all_of(logs.begin(), logs.end(), [&](const ShadowLog* log) {
        return countFits(*log, reading, arithmetic).all();
    });
}

std::optional<ShadowReading> readingThatFits(const Logs& logs, ShadowArithmetic arithmetic) {
    for (const ShadowReading& reading : acceptedShadowReadings())
        if (allFit(logs, reading, arithmetic)) return reading;
    return std::nullopt;
}

struct NamedArithmetic {
    ShadowArithmetic arithmetic;
    const char* id;
    const char* seen;
};

constexpr std::array kMistakes{
    NamedArithmetic{ShadowArithmetic::inverted, "shadow.inverted",
                    "Points that no ray's way is blocked from were expected to be lit; lit and "
                    "shadowed are exchanged."},
    NamedArithmetic{ShadowArithmetic::litIfAll, "shadow.all-or-nothing",
                    "At the edge of a shadow a fraction of the light was expected; there is all of "
                    "it where every ray arrives and none elsewhere."},
    NamedArithmetic{ShadowArithmetic::litIfAny, "shadow.all-or-nothing",
                    "At the edge of a shadow a fraction of the light was expected; there is all of "
                    "it as soon as one ray arrives."},
    NamedArithmetic{ShadowArithmetic::litIfHalf, "shadow.all-or-nothing",
                    "At the edge of a shadow a fraction of the light was expected; there is all of "
                    "it where more than half of the rays arrive and none elsewhere."},
    NamedArithmetic{
        ShadowArithmetic::ambientScaled, "shadow.ambient-scaled",
        "In shadow the ambient light was expected to stay; it is scaled like the rest."},
    NamedArithmetic{ShadowArithmetic::specularUnshadowed, "shadow.specular-unshadowed",
                    "In shadow no highlight was expected; the specular term is there in full."},
    NamedArithmetic{ShadowArithmetic::diffuseUnshadowed, "shadow.diffuse-unshadowed",
                    "In shadow no diffuse light was expected; the diffuse term is there in full."}};

ColourRGB inFullLight(const PointLog& point, const raytracer::SceneDescription& scene) {
    ColourRGB colour = ambientPart(point, scene);
    for (std::size_t i = 0; i < scene.pointLights.size(); ++i)
        colour += unshadowed(point, scene, i, false);
    return colour;
}

PhongTerms termsTowards(const PointLog& point, const raytracer::SceneDescription& scene) {
    const raytracer::PointLight& light = scene.pointLights[0];
    const Vector3 towards = light.position() - point.point.position;
    const double distance = towards.magnitude();
    return phongTerms(materialOf(scene, point.point.object), light, point.point.normal,
                      (point.point.viewer - point.point.position).normalised(), towards / distance,
                      distance);
}

bool near(const ColourRGB& a, const ColourRGB& b, const ColourRGB& slack) {
    return std::abs(a.r - b.r) <= slack.r && std::abs(a.g - b.g) <= slack.g &&
           std::abs(a.b - b.b) <= slack.b;
}

std::vector<double> listed(const ColourRGB& colour) {
    return {colour.r, colour.g, colour.b};
}

// Where some rays arrive and some do not, the value is everything or nothing, every time; elsewhere
// it is right.
bool neverAFraction(const Logs& logs) {
    std::size_t mixed = 0;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            const auto open = [](const AimLine& line) { return line.toLight == Sight::open; };
            const auto blocked = [](const AimLine& line) { return line.toLight == Sight::blocked; };
            const std::vector<AimLine>& lines = point.lines[0];
            const ColourRGB slack = toleranceAt(point, log->scene(), false);
            const bool all = near(point.colour, inFullLight(point, log->scene()), slack);
            const bool none = near(point.colour, ambientPart(point, log->scene()), slack);
            const bool anyOpen = std::any_of(lines.begin(), lines.end(), open);
            const bool anyBlocked = std::any_of(lines.begin(), lines.end(), blocked);
            const bool fitting = anyOpen && anyBlocked ? all || none : anyOpen ? all : none;
            if (!fitting) return false;
            if (anyOpen && anyBlocked) ++mixed;
        }
    return mixed >= 4;
}

// Geometry's word on a point that lies in full light or full shadow of every light.
std::optional<ColourRGB> knownColour(const PointLog& point,
                                     const raytracer::SceneDescription& scene, bool viewerIsEye) {
    ColourRGB expected = ambientPart(point, scene);
    for (std::size_t i = 0; i < point.zones.size(); ++i) {
        if (point.zones[i] == Zone::penumbra) return std::nullopt;
        if (point.zones[i] == Zone::lit) expected += unshadowed(point, scene, i, viewerIsEye);
    }
    return expected;
}

// Per-sample readings differ from the central one by terms of the light's angular size.
bool isNearKnown(const PointLog& point, const ShadowLog& log, bool viewerIsEye) {
    const std::optional<ColourRGB> expected = knownColour(point, log.scene(), viewerIsEye);
    if (!expected) return true;
    double nearest = 1e9;
    for (const raytracer::PointLight& light : log.scene().pointLights)
        nearest = std::min(nearest, (light.position() - point.point.position).magnitude());
    const double share = 0.05 + 2.0 * log.settings().lightSize / nearest;
    return near(point.colour, *expected, inFullLight(point, log.scene()) * share);
}

// Rays that hit something at once hit the surface that they leave; whoever sorts such hits out
// himself gets the right colours nevertheless.
bool shadowsItself(const Logs& logs, bool viewerIsEye) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i)
                for (const AimLine& line : point.lines[i])
                    if (point.zones[i] == Zone::lit && line.toLight != Sight::open &&
                        !isNearKnown(point, *log, viewerIsEye))
                        return true;
    return false;
}

/// The point whose value is farthest from the reading, for people to look at.
void addWorstPoint(const Logs& logs, Finding& finding) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            if (fits(point, log->scene(), log->settings(), {}, ShadowArithmetic::right)) continue;
            std::size_t open = 0;
            for (const std::vector<AimLine>& lines : point.lines)
                open += static_cast<std::size_t>(
                    std::count_if(lines.begin(), lines.end(),
                                  [](const AimLine& line) { return line.toLight == Sight::open; }));
            finding.evidence.emplace_back("raysThatArrive", static_cast<double>(open));
            finding.evidence.emplace_back("raysCast", static_cast<double>(point.lineCount()));
            finding.evidence.emplace_back("ambient", listed(ambientPart(point, log->scene())));
            finding.evidence.emplace_back("fullLight", listed(inFullLight(point, log->scene())));
            finding.evidence.emplace_back("seen", listed(point.colour));
            return;
        }
}

Finding unexplained(const Logs& logs) {
    Finding finding = distributedFinding(
        "shadow.wrong", Severity::fail,
        "The colours that illuminate gives were recomputed from the shadow rays that it cast; they "
        "fit neither the handout's steps nor a mistake that is known.");
    if (shadowsItself(logs, false) && shadowsItself(logs, true)) {
        finding.message =
            "Points in plain light were expected to be lit; some shadow rays are stopped by the "
            "very surface that they leave.";
        finding.hint = "Start the shadow rays at P + N * kShadowBias, a tiny step off the surface.";
    }
    addWorstPoint(logs, finding);
    return finding;
}

std::optional<Finding> knownMistake(const Logs& logs) {
    for (const NamedArithmetic& mistake : kMistakes) {
        if (!readingThatFits(logs, mistake.arithmetic)) continue;
        Finding finding = distributedFinding(mistake.id, Severity::fail, mistake.seen);
        addWorstPoint(logs, finding);
        return finding;
    }
    if (!neverAFraction(logs)) return std::nullopt;
    return distributedFinding("shadow.all-or-nothing", Severity::fail,
                              "At the edge of a shadow a fraction of the light was expected; there "
                              "is all of it or none, never a part.");
}

// Several lights, or a light with something behind it, can be wrong alone.
std::optional<Finding> checkRest(const ShadowLogs& logs, const ShadowReading& reading) {
    if (!allFit(logs.beyondLight, reading, ShadowArithmetic::right)) {
        Finding finding = distributedFinding(
            "shadow.beyond-light", Severity::fail,
            "A point in plain sight of the light was expected to be lit; an object behind the "
            "light casts a shadow on it.");
        addWorstPoint(logs.beyondLight, finding);
        if (allFit(logs.beyondLight, reading, ShadowArithmetic::endless)) return finding;
        return unexplained(logs.beyondLight);
    }
    if (!allFit(logs.severalLights, reading, ShadowArithmetic::right)) {
        Finding finding = distributedFinding(
            "shadow.lights-mixed", Severity::fail,
            "With one light the colours are right; with three lights each was expected to add its "
            "own light scaled by its own share, and what comes out is something else.");
        addWorstPoint(logs.severalLights, finding);
        return finding;
    }
    if (!allFit(logs.farLight, reading, ShadowArithmetic::right)) return unexplained(logs.farLight);
    return std::nullopt;
}

bool allNearKnown(const Logs& logs, bool viewerIsEye) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            if (!isNearKnown(point, *log, viewerIsEye)) return false;
    return true;
}

// Whether points in the shadow of their one light have this much of its diffuse and specular terms,
// and of the ambient one.
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

// Without rays, mistakes are known by what they leave in full shadow.
std::optional<Finding> knownValueMistake(const ShadowLogs& logs) {
    const auto named = [](ShadowArithmetic arithmetic) -> std::optional<Finding> {
        for (const NamedArithmetic& mistake : kMistakes)
            if (mistake.arithmetic == arithmetic)
                return distributedFinding(mistake.id, Severity::fail, mistake.seen);
        return std::nullopt;
    };
    if (allNearKnown(logs.oneLight, false)) {
        if (!allNearKnown(logs.beyondLight, false))
            return distributedFinding("shadow.beyond-light", Severity::fail,
                                      "A point in plain sight of the light was expected to be lit; "
                                      "an object behind the light casts a shadow on it.");
        if (!allNearKnown(logs.severalLights, false))
            return distributedFinding("shadow.lights-mixed", Severity::fail,
                                      "With one light the colours are right; with three lights "
                                      "they are not.");
        return std::nullopt;
    }
    if (shadowHolds(logs.oneLight, 0.0, false, false))
        return named(ShadowArithmetic::ambientScaled);
    if (shadowHolds(logs.oneLight, 1.0, false, true))
        return named(ShadowArithmetic::specularUnshadowed);
    if (shadowHolds(logs.oneLight, 1.0, true, false))
        return named(ShadowArithmetic::diffuseUnshadowed);
    if (!shadowHolds(logs.oneLight, 1.0, true, true)) return std::nullopt;
    if (!litWhereItShould(logs.oneLight)) return named(ShadowArithmetic::inverted);
    return distributedFinding("shadow.wrong", Severity::fail,
                              "Points in full shadow were expected to have ambient light alone; "
                              "nothing ever casts a shadow.");
}

}  // namespace

ArithmeticVerdict checkArithmetic(const ShadowLogs& logs) {
    ArithmeticVerdict verdict;
    std::optional<Finding> rest;
    for (const ShadowReading& reading : acceptedShadowReadings()) {
        if (!allFit(logs.oneLight, reading, ShadowArithmetic::right)) continue;
        std::optional<Finding> wrong = checkRest(logs, reading);
        if (!wrong) {
            verdict.reading = reading;
            // What fits may still be rays that never got off the surface.
            if (shadowsItself(logs.oneLight, reading.viewerIsEye))
                verdict.finding = unexplained(logs.oneLight);
            return verdict;
        }
        if (!rest) rest = std::move(wrong);
    }
    verdict.finding = rest ? rest : knownMistake(logs.oneLight);
    if (!verdict.finding) verdict.finding = unexplained(logs.oneLight);
    return verdict;
}

ArithmeticVerdict checkValues(const ShadowLogs& logs) {
    ArithmeticVerdict verdict;
    for (const bool viewerIsEye : {false, true}) {
        if (!allNearKnown(logs.atHandoutSettings(), viewerIsEye)) continue;
        verdict.reading = ShadowReading{ShadowReading::Phong::central, viewerIsEye, false};
        return verdict;
    }
    verdict.finding = knownValueMistake(logs);
    if (!verdict.finding)
        verdict.finding = distributedFinding("shadow.wrong", Severity::fail,
                                             "Points in full light and in full shadow have a known "
                                             "colour; illuminate gives another one.");
    return verdict;
}

}  // namespace ticker::decision
