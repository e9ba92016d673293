#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/KnownColours.h>
#include <grader/decision/distributed/ShadowChecks.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

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

// The point whose value is farthest from the reading, for people to look at.
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

// How many rays to the only light arrive, and which part of its light there is.
struct PartOfLight {
    std::size_t open = 0;
    std::size_t cast = 0;
    double part = 0.0;

    [[nodiscard]] double share() const {
        return static_cast<double>(open) / static_cast<double>(cast);
    }
};

// Empty where rounding decides, or where diffuse and specular light do not have the same part.
std::optional<PartOfLight> partOfLight(const PointLog& point, const ShadowLog& log) {
    constexpr double kSame = 1e-3;
    PartOfLight found;
    for (const AimLine& line : point.lines[0]) {
        if (line.toLight == Sight::unsure) return std::nullopt;
        if (line.toLight == Sight::open) ++found.open;
        ++found.cast;
    }
    if (found.cast == 0) return std::nullopt;
    const ColourRGB ambient = ambientPart(point, log.scene());
    const ColourRGB full = inFullLight(point, log.scene()) - ambient;
    const ColourRGB seen = point.colour - ambient;
    if (!(full.r + full.g + full.b > 0.0)) return std::nullopt;
    found.part = (seen.r + seen.g + seen.b) / (full.r + full.g + full.b);
    if (!near(seen, full * found.part, full * kSame)) return std::nullopt;
    return found;
}

// Says by an example what becomes of the share of rays, where light is scaled by one number.
void addShares(const Logs& logs, Finding& finding) {
    PartOfLight worst;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            const std::optional<PartOfLight> found = partOfLight(point, *log);
            if (!found) return;
            const double off = std::abs(found->part - found->share());
            if (worst.cast == 0 || off > std::abs(worst.part - worst.share())) worst = *found;
        }
    if (worst.cast == 0) return;
    finding.message += fmt::format(
        " Where {} of {} rays arrive, {:.3g} of the light was expected, and there is {:.3g} of it.",
        worst.open, worst.cast, worst.share(), worst.part);
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

Finding unexplainedWithOneLight(const Logs& logs) {
    Finding finding = unexplained(logs);
    addShares(logs, finding);
    return finding;
}

std::optional<Finding> knownMistake(const Logs& logs) {
    for (const ShadowArithmetic mistake : namedMistakes()) {
        if (!readingThatFits(logs, mistake)) continue;
        Finding finding = findingOf(mistake);
        addWorstPoint(logs, finding);
        return finding;
    }
    if (!neverAFraction(logs)) return std::nullopt;
    return distributedFinding("shadow.all-or-nothing", Severity::fail,
                              "At the edge of a shadow a fraction of the light was expected; there "
                              "is all of it or none, never a part.");
}

// In plain sight of the light nothing but what stands behind it can take light away.
bool onlyDarker(const Logs& logs) {
    return std::all_of(logs.begin(), logs.end(), [](const ShadowLog* log) {
        return std::all_of(log->points.begin(), log->points.end(), [&](const PointLog& point) {
            const ColourRGB most = inFullLight(point, log->scene()) * 1.01;
            return point.colour.r <= most.r && point.colour.g <= most.g && point.colour.b <= most.b;
        });
    });
}

// Past the light a ray may meet what its sample, wrongly, lies beyond of.
bool aimBesideTheLight(const Logs& logs) {
    constexpr double kBeside = 1.02;
    const auto beside = [](const ShadowLog& log, const PointLog& point) {
        return std::any_of(point.lines[0].begin(), point.lines[0].end(), [&](const AimLine& line) {
            return line.miss > kBeside * log.settings().lightSize;
        });
    };
    return std::any_of(logs.begin(), logs.end(), [&](const ShadowLog* log) {
        return std::any_of(log->points.begin(), log->points.end(),
                           [&](const PointLog& point) { return beside(*log, point); });
    });
}

// Several lights, a light with something behind it, or a wall can be wrong alone.
std::optional<Finding> checkRest(const ShadowLogs& logs, const ShadowReading& reading) {
    if (!allFit(logs.beyondLight, reading, ShadowArithmetic::right)) {
        Finding finding = distributedFinding(
            "shadow.beyond-light", Severity::fail,
            "A point in plain sight of the light was expected to be lit; an object behind the "
            "light casts a shadow on it.");
        addWorstPoint(logs.beyondLight, finding);
        if (allFit(logs.beyondLight, reading, ShadowArithmetic::endless) ||
            (onlyDarker(logs.beyondLight) && !aimBesideTheLight(logs.beyondLight)))
            return finding;
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
    if (!allFit(logs.planeShadow, reading, ShadowArithmetic::right)) {
        Finding finding = unexplained(logs.planeShadow);
        finding.message =
            "Spheres cast the shadows that were expected; a plane between a point and "
            "the light does not.";
        finding.hint = "Whatever a shadow ray hits before the light stops it, planes as well.";
        return finding;
    }
    if (!allFit(logs.farLight, reading, ShadowArithmetic::right)) return unexplained(logs.farLight);
    return std::nullopt;
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
    if (!verdict.finding) verdict.finding = unexplainedWithOneLight(logs.oneLight);
    return verdict;
}

}  // namespace ticker::decision
