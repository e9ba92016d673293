#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/PartOfLight.h>
#include <grader/tasks/shadows/checks/UnexplainedShadows.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace ticker::tasks {
namespace {

std::vector<double> listed(const ColourRGB& colour) {
    return {colour.r, colour.g, colour.b};
}

// Adds an example that compares the light's part with the share of rays, if one number scales the
// light.
void addShares(const std::vector<const ShadowLog*>& logs, Finding& finding) {
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

bool areReversed(const std::vector<const ShadowLog*>& logs) {
    return std::ranges::any_of(logs, [](const ShadowLog* log) {
        return std::ranges::any_of(log->points, [](const PointLog& point) {
            return std::ranges::any_of(point.lines, [](const std::vector<AimLine>& lines) {
                return std::ranges::any_of(lines, &AimLine::isReversed);
            });
        });
    });
}

}  // namespace

bool shadowsItself(const std::vector<const ShadowLog*>& logs, bool viewerIsEye) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i)
                for (const AimLine& line : point.lines[i])
                    if (point.zones[i] == Zone::lit && line.toLight != Sight::open &&
                        !isNearKnown(point, *log, viewerIsEye))
                        return true;
    return false;
}

bool leaksAtTheStart(const std::vector<const ShadowLog*>& logs, bool viewerIsEye) {
    const auto starts = [](const AimLine& line) { return line.toLight == Sight::unsure; };
    const auto leaks = [&](const ShadowLog& log, const PointLog& point) {
        for (std::size_t i = 0; i < point.lines.size(); ++i)
            if (point.zones[i] == Zone::umbra &&
                std::any_of(point.lines[i].begin(), point.lines[i].end(), starts))
                return !isNearKnown(point, log, viewerIsEye);
        return false;
    };
    return std::any_of(logs.begin(), logs.end(), [&](const ShadowLog* log) {
        return std::any_of(log->points.begin(), log->points.end(),
                           [&](const PointLog& point) { return leaks(*log, point); });
    });
}

Finding leakAtTheStart() {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "Points in full shadow were expected to be dark; some are lit, where shadow rays hit the "
        "very surface that they leave and nothing behind it is looked for.");
    finding.hint = "Start the shadow rays at P + N * kShadowBias, and count every hit.";
    return finding;
}

void addWorstPoint(const std::vector<const ShadowLog*>& logs, Finding& finding) {
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

Finding unexplainedShadows(const std::vector<const ShadowLog*>& logs) {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "The colours that illuminate gives were recomputed from the shadow rays that it cast; they "
        "fit neither the handout's steps nor a mistake that is known.");
    if (shadowsItself(logs, false) && shadowsItself(logs, true)) {
        finding.message =
            "Points in plain light were expected to be lit; some shadow rays are stopped by the "
            "very surface that they leave.";
        finding.hint = "Start the shadow rays at P + N * kShadowBias, a tiny step off the surface.";
    }
    if (areReversed(logs)) {
        finding.message += " They run from the light to the point.";
        finding.hint =
            "The surface that is lit is the last one that such a ray meets, at its full length. "
            "Rounding decides which of the two is longer: count a hit as blocking only if it is "
            "nearer by 1e-4 or so, or start at P + N * kShadowBias and cast the ray to the light.";
    }
    addWorstPoint(logs, finding);
    return finding;
}

Finding unexplainedWithOneLight(const std::vector<const ShadowLog*>& logs) {
    Finding finding = unexplainedShadows(logs);
    addShares(logs, finding);
    return finding;
}

}  // namespace ticker::tasks
