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

bool hasLevel(const PointLog& point) {
    return std::ranges::any_of(point.lines[0],
                               [&](const AimLine& line) { return isLevel(line, point); });
}

bool isBelow(const AimLine& line, const PointLog& point) {
    return slopeOf(line, point) <= -kLevel;
}

PointLog levelSeenAs(Sight sight, PointLog point) {
    for (AimLine& line : point.lines[0])
        if (isLevel(line, point)) line.toLight = sight;
    return point;
}

PointLog belowSeenAs(Sight sight, PointLog point) {
    for (AimLine& line : point.lines[0])
        if (isBelow(line, point)) line.toLight = line.endlessly = sight;
    return point;
}

PointLog withoutBelow(PointLog point) {
    std::erase_if(point.lines[0], [&](const AimLine& line) { return isBelow(line, point); });
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

// Whether the rays that were not cast count as blocked, and those below the horizon as blocked or,
// in code that ignores hits on the object that they leave, as open. Tries all accepted readings:
// the one that fits elsewhere may do so only because its intervals are wide, and the code's own may
// be another, which shows here, where the rays differ most in N.L.
bool countsEvery(const ShadowLog& log, Sight below) {
    std::vector<PointLog> points;
    for (const PointLog& point : log.points)
        if (!point.lines[0].empty())
            points.push_back(
                filledUp(levelSeenAs(Sight::unsure, belowSeenAs(below, point)), askedOf(log)));
    return std::ranges::any_of(acceptedShadowReadings(), [&](const ShadowReading& reading) {
        return std::ranges::all_of(
            points, [&](const PointLog& point) { return isRight(point, log, reading); });
    });
}

// Whether the floor surely blocks every ray below the horizon. Where rays start on the floor
// itself, rounding decides whether they hit it.
bool isSureBelow(const ShadowLog& log) {
    return std::ranges::all_of(log.points, [](const PointLog& point) {
        return std::ranges::none_of(point.lines[0], [&](const AimLine& line) {
            return isBelow(line, point) && line.toLight == Sight::unsure;
        });
    });
}

// A point whose light is the share of its rays above the horizon.
struct ShareAbove {
    std::size_t above = 0;    // rays above the horizon
    std::size_t arrived = 0;  // of these
    std::size_t all = 0;      // rays that were asked for, or cast if these are more
};

// The clearest example of a point whose light is the share of the rays above the horizon alone,
// whether the others were cast or not. None if some point does not have that share, or if every ray
// may count after all. A point with a level ray may have another share: that ray may arrive, and be
// left out of the divisor alone.
std::optional<ShareAbove> leftOut(const ShadowLog& log, const ShadowReading& reading) {
    if (reading.terms != ShadowReading::Terms::together || !isSureBelow(log)) return std::nullopt;
    std::optional<ShareAbove> clearest;
    for (const PointLog& point : log.points) {
        const PointLog seen = levelSeenAs(Sight::unsure, withoutBelow(point));
        const ShareAbove share{seen.lines[0].size(), openOf(seen),
                               std::max(askedOf(log), point.lines[0].size())};
        if (share.above == share.all || share.arrived == 0) continue;
        if (!isRight(seen, log, reading)) {
            if (hasLevel(seen)) continue;
            return std::nullopt;
        }
        if (isRight(filledUp(seen, share.all), log, reading)) continue;
        if (!clearest || share.above < clearest->above) clearest = share;
    }
    if (clearest && (countsEvery(log, Sight::blocked) || countsEvery(log, Sight::open)))
        return std::nullopt;
    return clearest;
}

// Whether the light is the share of all rays that were cast.
// Code that casts more rays than asked for may leave out those below the horizon. Its light is then
// not the share of the remaining rays: about one in a hundred of these is level, and each of the 24
// points would need some. If all points have the same number of rays, none were left out, except
// with a chance of 1e-10, and any accepted reading may fit.
// Code that moves aims onto the horizon is right if all rays there count as blocked. At least 1 in
// 24 of its rays is level, except with a chance of 1e-7.
// @param manyLevel  Whether at least 1 in 24 rays is level.
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
            if (isBelow(line, point)) return false;
            if (isLevel(line, point)) ++level;
        }
        lines += point.lines[0].size();
    }
    return std::min(lines, aims.distinct) >= kEnough &&
           countsAll(log, reading, level * kMoved >= lines);
}

bool isDarkened(const PointLog& point, const ShadowLog& log) {
    const ColourRGB ambient = ambientPart(point, log.scene());
    const ColourRGB least = ambient - toleranceAt(point, log.scene(), false);
    return point.colour.r < least.r || point.colour.g < least.g || point.colour.b < least.b;
}

// Whether the light makes a point darker than its ambient light, which no accepted reading does.
std::optional<Finding> checkDarkened(const ShadowLog& log) {
    if (std::ranges::none_of(log.points,
                             [&](const PointLog& point) { return isDarkened(point, log); }))
        return std::nullopt;
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "Where the centre of a light is below the surface's horizon and a part of it is above, at "
        "least the ambient light was expected; it is darker there: the light takes some away.");
    finding.hint =
        "N.L is negative there. Keep std::max(0.0, N.dot(L)): the shadow rays do not replace it, "
        "since those to the part above the horizon arrive.";
    finding.section = "Soft shadows (T2.1), step 2";
    return finding;
}

constexpr const char* kExpected =
    "Where a part of the light is below the surface's horizon, the share of all shadow rays was "
    "expected, and none arrives from there; ";

}  // namespace

std::optional<Finding> checkHorizon(const ShadowLogs& logs, const AimVerdict& aims,
                                    const ShadowReading& reading) {
    for (const ShadowLog* log : logs.horizon) {
        if (std::optional<Finding> darkened = checkDarkened(*log)) return darkened;
        if (const std::optional<ShareAbove> share = leftOut(*log, reading)) {
            Finding finding = distributedFinding(
                kShadowWrong, Severity::fail,
                kExpected + fmt::format("where {0} of {1} rays are above it and {2} arrive, there "
                                        "is {2}/{0} of the light instead of {2}/{1}.",
                                        share->above, share->all, share->arrived));
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
