#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/ExplainedShadows.h>
#include <grader/tasks/shadows/checks/HighlightCheck.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/UnexplainedShadows.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace ticker::tasks {
namespace {

using Logs = std::vector<const ShadowLog*>;

bool allFit(const Logs& logs, const ShadowReading& reading, ShadowArithmetic arithmetic) {
    return std::all_of(logs.begin(), logs.end(),
                       [&](const ShadowLog* log) { return allFit(*log, reading, arithmetic); });
}

std::optional<ShadowReading> readingThatFits(const Logs& logs, ShadowArithmetic arithmetic) {
    for (const ShadowReading& reading : acceptedShadowReadings())
        if (allFit(logs, reading, arithmetic)) return reading;
    return std::nullopt;
}

// Whether points with some rays blocked have all light or no light, every time, and all other
// points are right.
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

std::optional<Finding> knownMistake(const Logs& logs) {
    for (const ShadowArithmetic mistake : namedMistakes()) {
        if (!readingThatFits(logs, mistake)) continue;
        Finding finding = findingOf(mistake);
        addWorstPoint(logs, finding);
        return finding;
    }
    if (!neverAFraction(logs)) return std::nullopt;
    return distributedFinding(kShadowAllOrNothing, Severity::fail,
                              "At the edge of a shadow a fraction of the light was expected; there "
                              "is all of it or none, never a part.");
}

// Whether points in plain sight of the light are only darker than they should be: the cause lies
// behind the light.
bool onlyDarker(const Logs& logs) {
    return std::all_of(logs.begin(), logs.end(), [](const ShadowLog* log) {
        return std::all_of(log->points.begin(), log->points.end(), [&](const PointLog& point) {
            const ColourRGB most = inFullLight(point, log->scene()) * 1.01;
            return point.colour.r <= most.r && point.colour.g <= most.g && point.colour.b <= most.b;
        });
    });
}

// Whether some ray misses the light. Such a ray may meet an object beyond its sample.
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

// An object behind the light.
std::optional<Finding> checkBeyondLight(const Logs& logs, const ShadowReading& reading) {
    if (allFit(logs, reading, ShadowArithmetic::right)) return std::nullopt;
    const bool blocks = allFit(logs, reading, ShadowArithmetic::endless);
    if (!blocks && (!onlyDarker(logs) || aimBesideTheLight(logs))) return unexplainedShadows(logs);
    Finding finding = distributedFinding(
        kShadowBeyondLight, Severity::fail,
        fmt::format("A point in plain sight of the light was expected to be lit; an object behind "
                    "the light {}.",
                    blocks ? "casts a shadow on it" : "makes it darker"));
    if (!blocks)
        finding.hint +=
            " Nor does the distance of a hit say how far away the light is: that is "
            "(light.position() - P).magnitude().";
    addWorstPoint(logs, finding);
    return finding;
}

std::optional<Finding> checkSeveralLights(const Logs& logs, const ShadowReading& reading) {
    if (allFit(logs, reading, ShadowArithmetic::right)) return std::nullopt;
    Finding finding =
        allFit(logs, reading, ShadowArithmetic::ambientForEachLight)
            ? ambientForEachLight()
            : distributedFinding(
                  kShadowLightsMixed, Severity::fail,
                  "With one light the colours are right; with several lights each was expected to "
                  "add its own light scaled by its own share, and what comes out is something "
                  "else.");
    addWorstPoint(logs, finding);
    return finding;
}

// Checks what can be wrong by itself: several lights, a light with an object behind it or just
// before it, a wall.
std::optional<Finding> checkRest(const ShadowLogs& logs, const ShadowReading& reading) {
    const auto fits = [&](const Logs& asked) {
        return allFit(asked, reading, ShadowArithmetic::right);
    };
    const auto withWorst = [](Finding finding, const Logs& asked) {
        addWorstPoint(asked, finding);
        return finding;
    };
    if (auto beyond = checkBeyondLight(logs.beyondLight, reading)) return beyond;
    // Before the check of several lights, which would report the same highlights as mixed lights.
    if (!fits(logs.lowLight)) {
        const auto highlight = highlightOfLowLight(logs.lowLight);
        return highlight ? highlight : unexplainedShadows(logs.lowLight);
    }
    if (auto several = checkSeveralLights(logs.severalLights, reading)) return several;
    if (!fits(logs.planeShadow)) return withWorst(planesCastNothing(), logs.planeShadow);
    if (!fits(logs.lightBehind)) return lightsLostBehind();
    if (!fits(logs.nearLight)) return withWorst(nearLightMissed(), logs.nearLight);
    if (!fits(logs.farLight)) return unexplainedShadows(logs.farLight);
    if (!fits(logs.pureColours)) return withWorst(channelsLost(), logs.pureColours);
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
            // Rays that hit the surface they leave can fit, too (shadow acne).
            if (shadowsItself(logs.oneLight, reading.viewerIsEye))
                verdict.finding = unexplainedShadows(logs.oneLight);
            else if (leaksAtTheStart(logs.oneLight, reading.viewerIsEye))
                verdict.finding = leakAtTheStart();
            return verdict;
        }
        if (!rest) rest = std::move(wrong);
    }
    verdict.finding = rest ? rest : knownMistake(logs.oneLight);
    if (!verdict.finding) verdict.finding = highlightAlone(logs.oneLight);
    if (!verdict.finding) verdict.finding = explainedShadows(logs.oneLight);
    if (!verdict.finding) verdict.finding = unexplainedWithOneLight(logs.oneLight);
    return verdict;
}

}  // namespace ticker::tasks
