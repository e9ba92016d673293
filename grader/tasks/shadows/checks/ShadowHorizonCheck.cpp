#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace ticker::tasks {
namespace {

std::size_t askedOf(const ShadowLog& log) {
    return static_cast<std::size_t>(log.settings().shadowRayCount);
}

std::size_t openOf(const PointLog& point) {
    return static_cast<std::size_t>(
        std::ranges::count(point.lines[0], Sight::open, &AimLine::toLight));
}

// Adds blocked rays in place of those that were not cast.
PointLog filledUp(PointLog point, std::size_t asked) {
    AimLine blocked = point.lines[0].front();
    blocked.toLight = blocked.endlessly = Sight::blocked;
    point.lines[0].resize(std::max(asked, point.lines[0].size()), blocked);
    return point;
}

bool isRight(const PointLog& point, const ShadowLog& log, const ShadowReading& reading) {
    return fits(point, log.scene(), log.settings(), reading, ShadowArithmetic::right);
}

// The clearest example, if every point with fewer rays than asked for has the share of the rays
// that were cast. Counting the missing rays as blocked gives a smaller share, unless it is 0.
const PointLog* leftOut(const ShadowLog& log, const ShadowReading& reading) {
    const PointLog* clearest = nullptr;
    for (const PointLog& point : log.points) {
        const std::size_t cast = point.lines[0].size();
        if (cast == 0 || cast >= askedOf(log) || openOf(point) == 0) continue;
        if (!isRight(point, log, reading)) return nullptr;
        if (isRight(filledUp(point, askedOf(log)), log, reading)) continue;
        if (clearest == nullptr || cast < clearest->lines[0].size()) clearest = &point;
    }
    return clearest;
}

// A sixth or more of independent aims go below the horizon for every accepted shape: the chance
// that none of 200 does is below 1e-15.
// Code that casts more rays than asked for may spare those below: its share is then not that of the
// rays that are left.
bool noneGoesBelow(const ShadowLog& log, const AimVerdict& aims, const ShadowReading& reading) {
    constexpr std::size_t kEnough = 200;
    // A ray that starts off the surface goes down a little to an aim on the horizon, 2.3 or more
    // away.
    constexpr double kLevel = kLargestBias / 2.3;
    std::size_t lines = 0;
    for (const PointLog& point : log.points) {
        if (point.lines[0].size() < askedOf(log) || !isRight(point, log, reading)) return false;
        for (const AimLine& line : point.lines[0])
            if (line.direction.dot(point.point.normal) <= -kLevel) return false;
        lines += point.lines[0].size();
    }
    return std::min(lines, aims.distinct) >= kEnough;
}

constexpr const char* kExpected =
    "Where a part of the light is below the surface's horizon, the share of all shadow rays was "
    "expected, and none arrives from there; ";

}  // namespace

std::optional<Finding> checkHorizon(const ShadowLogs& logs, const AimVerdict& aims,
                                    const ShadowReading& reading) {
    if (reading.terms != ShadowReading::Terms::together) return std::nullopt;
    for (const ShadowLog* log : logs.horizon) {
        const std::size_t asked = askedOf(*log);
        if (const PointLog* point = leftOut(*log, reading)) {
            Finding finding = distributedFinding(
                kShadowWrong, Severity::fail,
                kExpected + fmt::format("where {0} of {1} rays are above it and {2} arrive, there "
                                        "is {2}/{0} of the light instead of {2}/{1}.",
                                        point->lines[0].size(), asked, openOf(*point)));
            finding.hint =
                "A ray below the horizon (towards.dot(N) <= 0) may be spared, but it counts as "
                "blocked: divide by settings().shadowRayCount, not by the number of rays that are "
                "left.";
            finding.section = "Soft shadows (T2.1), step 2";
            return finding;
        }
        if (noneGoesBelow(*log, aims, reading)) {
            Finding finding = distributedFinding(
                kShadowWrong, Severity::fail,
                kExpected + std::string{"no ray goes there, and all the light arrives."});
            finding.hint =
                "Take each random point of the light as it is drawn: do not draw it again, mirror "
                "it or move it where it is below the horizon. Such a ray is blocked by the surface "
                "itself, and counts.";
            finding.section = "Soft shadows (T2.1), step 1";
            return finding;
        }
    }
    return std::nullopt;
}

}  // namespace ticker::tasks
