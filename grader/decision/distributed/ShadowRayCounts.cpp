#include <grader/decision/distributed/FindingText.h>
#include <grader/decision/distributed/ShadowChecks.h>
#include <grader/decision/distributed/ShadowRayCounts.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace ticker::decision {
namespace {

/// Whether the surface looks at the light; others may be spared their rays.
bool faces(const PointLog& point, const raytracer::PointLight& light) {
    const Vector3 towards = (light.position() - point.point.position).normalised();
    return towards.dot(point.point.normal) > 0.05;
}

}  // namespace

double biasOf(const AimLine& line, const PointLog& point) {
    return (line.origin - point.point.position).magnitude();
}

std::size_t distinctRays(const std::vector<AimLine>& lines) {
    std::set<std::array<std::int64_t, 6>> seen;
    const auto cell = [](double value) { return std::llround(value * 1e12); };
    for (const AimLine& line : lines)
        seen.insert({cell(line.direction.x), cell(line.direction.y), cell(line.direction.z),
                     cell(line.origin.x), cell(line.origin.y), cell(line.origin.z)});
    return seen.size();
}

RayCounts countRays(const std::vector<const ShadowLog*>& logs) {
    RayCounts counts;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i) {
                if (!faces(point, log->scene().pointLights[i])) continue;
                const std::vector<AimLine>& lines = point.lines[i];
                const std::size_t distinct = distinctRays(lines);
                counts.fewest = std::min(counts.fewest, lines.size());
                counts.fewestDistinct = std::min(counts.fewestDistinct, distinct);
                counts.most = std::max(counts.most, lines.size());
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
            "shadow.hard", Severity::fail,
            counts.allCentral
                ? fmt::format("{} shadow rays to random points of the light were expected; every "
                              "ray goes to the light's centre.",
                              asked)
                : fmt::format(
                      "{} shadow rays for each point and light were expected; there is one.",
                      asked));
    } else if (counts.fewest < asked) {
        finding = distributedFinding(
            "shadow.too-few-rays", Severity::fail,
            fmt::format("{} shadow rays for each point and light were expected; at some points "
                        "there are {}.",
                        asked, counts.fewest));
    } else if (counts.fewestDistinct < asked && !fixed) {
        finding = distributedFinding(
            "shadow.too-few-rays", Severity::fail,
            fmt::format("{} different shadow rays for each point and light were expected; at some "
                        "points only {} of them differ.",
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

// Lights that get no ray at all are another finding.
std::optional<Finding> checkSeveralCounts(const ShadowLogs& logs) {
    const auto asked = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    std::size_t fewest = asked;
    for (const ShadowLog* log : logs.severalLights)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i)
                if (faces(point, log->scene().pointLights[i]) && !point.lines[i].empty())
                    fewest = std::min(fewest, point.lines[i].size());
    if (fewest >= asked) return std::nullopt;
    Finding finding = distributedFinding(
        "shadow.too-few-rays", Severity::fail,
        fmt::format("{} shadow rays to each light were expected; with three lights in the scene, "
                    "some light gets {}.",
                    asked, fewest));
    finding.evidence.emplace_back("raysExpected", static_cast<double>(asked));
    finding.evidence.emplace_back("fewestRays", static_cast<double>(fewest));
    return finding;
}

std::optional<Finding> checkEveryLight(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.severalLights)
        for (const PointLog& point : log->points)
            for (std::size_t i = 0; i < point.lines.size(); ++i)
                if (faces(point, log->scene().pointLights[i]) && point.lines[i].empty())
                    return distributedFinding(
                        "shadow.lights-mixed", Severity::fail,
                        "Shadow rays to every light were expected; with three lights in the scene, "
                        "some lights get none.");
    return std::nullopt;
}

}  // namespace ticker::decision
