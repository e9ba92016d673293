#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/Distinct.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

/// Whether the surface faces the light; code may skip the rays to other lights.
bool faces(const PointLog& point, const raytracer::PointLight& light) {
    const Vector3 towards = (light.position() - point.point.position).normalised();
    return towards.dot(point.point.normal) > 0.05;
}

Finding fewRays(std::size_t asked, std::size_t fewest) {
    Finding finding = distributedFinding(
        kShadowTooFewRays, Severity::fail,
        fmt::format("{} shadow rays for each point and light were expected; at some points there "
                    "are {}.",
                    asked, fewest));
    if (fewest == 0)
        finding.hint =
            "Every point that the light can reach needs rays of its own in each call: keep no "
            "share from another point (no cache, nothing static or thread_local), and skip the "
            "loop nowhere. " +
            finding.hint;
    return finding;
}

}  // namespace

double biasOf(const AimLine& line, const PointLog& point) {
    return (line.origin - point.point.position).magnitude();
}

std::size_t distinctRays(const std::vector<AimLine>& lines) {
    std::vector<std::array<std::int64_t, 6>> seen;
    seen.reserve(lines.size());
    std::size_t added = 0;
    const auto cell = [](double value) { return std::llround(value * 1e12); };
    for (const AimLine& line : lines) {
        if (line.isAdded)
            ++added;
        else
            seen.push_back({cell(line.direction.x), cell(line.direction.y), cell(line.direction.z),
                            cell(line.origin.x), cell(line.origin.y), cell(line.origin.z)});
    }
    return numberOfDifferent(std::move(seen)) + added;
}

RayCounts countRays(const std::vector<const ShadowLog*>& logs, bool lightsWithoutRays) {
    RayCounts counts;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i) {
                if (!faces(point, log->scene().pointLights[i])) continue;
                const std::vector<AimLine>& lines = point.lines[i];
                if (lines.empty() && !lightsWithoutRays) continue;
                const std::size_t distinct = distinctRays(lines);
                counts.fewest = std::min(counts.fewest, lines.size());
                counts.fewestDistinct = std::min(counts.fewestDistinct, distinct);
                counts.most = std::max(counts.most, lines.size());
                counts.mostDistinct = std::max(counts.mostDistinct, distinct);
                ++counts.places;
                if (distinct < static_cast<std::size_t>(log->settings().shadowRayCount))
                    ++counts.repeating;
                for (const AimLine& line : lines)
                    if (line.miss > 1.01 * std::min(biasOf(line, point), kLargestBias) + 1e-7)
                        counts.allCentral = false;
            }
    return counts;
}

double widestMiss(const std::vector<const ShadowLog*>& logs) {
    double widest = 0.0;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            for (const std::vector<AimLine>& lines : point.lines)
                for (const AimLine& line : lines)
                    widest = std::max(widest, line.miss);
    return widest;
}

std::optional<Finding> checkRayCounts(const ShadowLogs& logs, bool fixed) {
    std::vector<const ShadowLog*> single = logs.oneLight;
    single.insert(single.end(), logs.beyondLight.begin(), logs.beyondLight.end());
    single.insert(single.end(), logs.farLight.begin(), logs.farLight.end());
    const RayCounts counts = countRays(single);
    const std::size_t asked = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    std::optional<Finding> finding;
    if (counts.allCentral || counts.most <= 1) {
        finding = distributedFinding(
            kShadowHard, Severity::fail,
            counts.allCentral
                ? fmt::format("{} shadow rays to random points of the light were expected; every "
                              "ray goes to the light's centre.",
                              asked)
                : fmt::format(
                      "{} shadow rays for each point and light were expected; there is one.",
                      asked));
    } else if (counts.fewest < asked) {
        finding = fewRays(asked, counts.fewest);
    } else if (counts.repeats(asked) && !fixed) {
        finding = distributedFinding(
            kShadowTooFewRays, Severity::fail,
            fmt::format("{} different shadow rays for each point and light were expected; at some "
                        "points enough are cast, but the number of different ones is {}.",
                        asked, counts.fewestDistinct));
    }
    if (finding) {
        finding->evidence.emplace_back("raysExpected", static_cast<double>(asked));
        finding->evidence.emplace_back("fewestRays", static_cast<double>(counts.fewest));
        finding->evidence.emplace_back("fewestDistinctRays",
                                       static_cast<double>(counts.fewestDistinct));
    }
    return finding;
}

// Lights without any ray are another finding.
std::optional<Finding> checkSeveralCounts(const ShadowLogs& logs, bool fixed) {
    const auto asked = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    const RayCounts counts = countRays(logs.severalLights, false);
    const bool copies = counts.fewest >= asked && counts.repeats(asked) && !fixed;
    if (counts.fewest >= asked && !copies) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowTooFewRays, Severity::fail,
        fmt::format("{0} {1}shadow rays to each light were expected; with several "
                    "lights in the scene, some light gets fewer {1}rays: {2}.",
                    asked, copies ? "different " : "",
                    copies ? counts.fewestDistinct : counts.fewest));
    finding.evidence.emplace_back("raysExpected", static_cast<double>(asked));
    finding.evidence.emplace_back("fewestRays", static_cast<double>(counts.fewest));
    finding.evidence.emplace_back("fewestDistinctRays", static_cast<double>(counts.fewestDistinct));
    return finding;
}

// Judges the width of each light only; shapes are judged at far lights. For every accepted shape at
// least one of 170 lines passes outside of 0.65 radii, except with a chance of kStatementRisk (with
// uniform radius and direction 86 % of the lines pass within).
std::optional<Finding> checkSeveralSizes(const ShadowLogs& logs, const AimVerdict& aims) {
    constexpr std::size_t kEnough = 170;
    constexpr double kInner = 0.65;
    const double radius = raytracer::RenderSettings{}.lightSize;
    for (const ShadowLog* log : logs.severalLights)
        for (std::size_t i = 0; i < log->scene().pointLights.size(); ++i) {
            double widest = 0.0;
            std::size_t lines = 0;
            for (const PointLog& point : log->points)
                for (const AimLine& line : point.lines[i]) {
                    widest = std::max(widest, line.miss);
                    if (!line.isAdded) ++lines;
                }
            const bool narrow =
                std::min(lines, aims.distinct) >= kEnough && widest < kInner * radius;
            if (!narrow && widest <= radius * (1.0 + 1e-6) + kLargestBias) continue;
            Finding finding = distributedFinding(
                kShadowLightSize, Severity::fail,
                fmt::format("Every light is a ball of radius {}; with several lights in the scene, "
                            "the rays to one of them pass within {:.3g} of its centre.",
                            radius, widest));
            finding.evidence.emplace_back("widest", widest);
            finding.evidence.emplace_back("widestExpected", radius);
            finding.evidence.emplace_back("light", static_cast<double>(i));
            return finding;
        }
    return std::nullopt;
}

std::optional<Finding> checkEveryLight(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.severalLights)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i)
                if (faces(point, log->scene().pointLights[i]) && point.lines[i].empty())
                    return distributedFinding(kShadowLightsMixed, Severity::fail,
                                              "Shadow rays to every light were expected; with "
                                              "several lights in the scene, "
                                              "some lights get none.");
    for (const ShadowLog* log : logs.lightBehind)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i)
                if (faces(point, log->scene().pointLights[i]) && point.lines[i].empty())
                    return lightsLostBehind();
    return std::nullopt;
}

}  // namespace ticker::tasks
