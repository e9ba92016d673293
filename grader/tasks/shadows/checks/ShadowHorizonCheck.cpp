#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ticker::tasks {
namespace {

std::size_t askedOf(const ShadowLog& log) {
    return static_cast<std::size_t>(log.settings().shadowRayCount);
}

// Slope of a ray that starts above the surface, by the largest bias, and aims at the horizon: the
// aim is 2.3 world units away or more, so that the ray goes down a little.
constexpr double kLevel = kLargestBias / 2.3;

double slopeOf(const AimLine& line, const PointLog& point) {
    return line.direction.dot(point.point.normal);
}

// Whether the ray is so level that it meets the floor, if at all, near its aim. Which of the two
// comes first is unknown, since the place of the aim on the line is not visible.
bool isLevel(const AimLine& line, const PointLog& point) {
    constexpr double kSinglePrecision = 1e-6;
    const double slope = slopeOf(line, point);
    return slope > -kLevel && slope < kSinglePrecision;
}

PointLog levelSeenAs(Sight sight, PointLog point) {
    for (AimLine& line : point.lines[0])
        if (isLevel(line, point)) line.toLight = sight;
    return point;
}

std::size_t openOf(const PointLog& point) {
    return static_cast<std::size_t>(std::ranges::count_if(point.lines[0], [&](const AimLine& line) {
        return line.toLight == Sight::open || isLevel(line, point);
    }));
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

bool allRight(const ShadowLog& log, const ShadowReading& reading, Sight level) {
    return std::ranges::all_of(log.points, [&](const PointLog& point) {
        return isRight(levelSeenAs(level, point), log, reading);
    });
}

// Whether the rays that were not cast count as blocked, under any accepted reading. The reading
// that fits elsewhere does not decide: it may fit only since its interval is wide, and here, where
// the rays differ most in N.L, the code's own reading may be another.
bool countsMissing(ShadowLog log) {
    for (PointLog& point : log.points)
        if (!point.lines[0].empty())
            point = filledUp(levelSeenAs(Sight::unsure, point), askedOf(log));
    return std::ranges::any_of(acceptedShadowReadings(), [&](const ShadowReading& reading) {
        return std::ranges::all_of(
            log.points, [&](const PointLog& point) { return isRight(point, log, reading); });
    });
}

// The clearest example of a point whose light is the share of the rays that were cast, and not of
// those that were asked for. Null if some point with fewer rays does not have that share, or if the
// missing rays may count as blocked after all.
const PointLog* leftOut(const ShadowLog& log, const ShadowReading& reading) {
    if (reading.terms != ShadowReading::Terms::together) return nullptr;
    const PointLog* clearest = nullptr;
    for (const PointLog& point : log.points) {
        const std::size_t cast = point.lines[0].size();
        if (cast == 0 || cast >= askedOf(log) || openOf(point) == 0) continue;
        const PointLog seen = levelSeenAs(Sight::unsure, point);
        if (!isRight(seen, log, reading)) return nullptr;
        if (isRight(filledUp(seen, askedOf(log)), log, reading)) continue;
        if (clearest == nullptr || cast < clearest->lines[0].size()) clearest = &point;
    }
    return clearest != nullptr && countsMissing(log) ? nullptr : clearest;
}

// Whether the light is the share of all rays that were cast.
// Code that casts more rays than asked for may leave out those below the horizon. Its light is then
// not the share of the remaining rays: about one in a hundred of these is level, and each of the 24
// points would need some. If all points have the same number of rays, none were left out, except
// with a chance of 1e-10, and any accepted reading may fit.
// Code that moves aims onto the horizon is right if all rays there count as blocked. At least 1 in
// 24 of its rays is level, except with a chance of 1e-7.
// @param manyLevel  Whether so many rays are level.
bool countsAll(const ShadowLog& log, const ShadowReading& reading, bool manyLevel) {
    const std::size_t first = log.points.front().lines[0].size();
    const bool evenly = std::ranges::all_of(
        log.points, [&](const PointLog& point) { return point.lines[0].size() == first; });
    const std::vector<ShadowReading> readings =
        evenly ? acceptedShadowReadings() : std::vector{reading};
    const auto fitAny = [&](Sight level) {
        return std::ranges::any_of(
            readings, [&](const ShadowReading& some) { return allRight(log, some, level); });
    };
    return fitAny(Sight::unsure) && !(manyLevel && fitAny(Sight::blocked));
}

// A sixth or more of independent aims go below the horizon for every accepted shape: the chance
// that none of 200 does is below 1e-15.
bool noneGoesBelow(const ShadowLog& log, const AimVerdict& aims, const ShadowReading& reading) {
    constexpr std::size_t kEnough = 200;
    constexpr std::size_t kMoved = 24;
    std::size_t lines = 0;
    std::size_t level = 0;
    for (const PointLog& point : log.points) {
        if (point.lines[0].size() < askedOf(log)) return false;
        for (const AimLine& line : point.lines[0]) {
            if (slopeOf(line, point) <= -kLevel) return false;
            if (isLevel(line, point)) ++level;
        }
        lines += point.lines[0].size();
    }
    return std::min(lines, aims.distinct) >= kEnough &&
           countsAll(log, reading, level * kMoved >= lines);
}

constexpr const char* kExpected =
    "Where a part of the light is below the surface's horizon, the share of all shadow rays was "
    "expected, and none arrives from there; ";

}  // namespace

std::optional<Finding> checkHorizon(const ShadowLogs& logs, const AimVerdict& aims,
                                    const ShadowReading& reading) {
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
                kExpected + std::string{"no ray goes there, and more light arrives than should."});
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
