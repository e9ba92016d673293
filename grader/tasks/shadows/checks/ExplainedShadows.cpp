#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>
#include <grader/tasks/shadows/checks/ExplainedShadows.h>
#include <grader/tasks/shadows/checks/PartOfLight.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

namespace ticker::tasks {
namespace {

using Logs = std::vector<const ShadowLog*>;

bool someReadingFits(const std::vector<ShadowLog>& logs) {
    return std::ranges::any_of(acceptedShadowReadings(), [&](const ShadowReading& reading) {
        return std::ranges::all_of(logs, [&](const ShadowLog& log) {
            return allFit(log, reading, ShadowArithmetic::right);
        });
    });
}

double channels(const ColourRGB& colour) {
    return colour.r + colour.g + colour.b;
}

bool allBlocked(const PointLog& point) {
    return !point.lines[0].empty() && std::ranges::all_of(point.lines[0], [](const AimLine& line) {
        return line.toLight == Sight::blocked;
    });
}

// Factor of the ambient light at a point that has no other light. Empty without such a point.
std::optional<double> ambientInShadow(const Logs& logs) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            const double ambient = channels(ambientPart(point, log->scene()));
            if (ambient > 0.0 && allBlocked(point)) return channels(point.colour) / ambient;
        }
    return std::nullopt;
}

bool isTimes(double a, double b) {
    constexpr double kSame = 0.01;
    return std::abs(a - b) <= kSame * b;
}

std::string ambientHint(double times) {
    const double rays = raytracer::RenderSettings{}.shadowRayCount;
    std::string hint =
        "The ambient light is object.colour() * scene.ambientLighting(): add it once, undivided, "
        "before the loop over the lights.";
    if (isTimes(times, 1.0 / rays))
        return hint +
               " Do not divide the whole colour by the number of rays: divide what the rays of one "
               "light add, then add that to the colour.";
    if (isTimes(times, rays) || isTimes(times, rays + 1.0))
        return hint + " It belongs to the point: it is there once, not once for each ray.";
    return hint + " No share, number of rays or coefficient scales it.";
}

std::optional<Finding> ambientScaledEvenly(const Logs& logs) {
    constexpr double kLeast = 0.01;
    const std::optional<double> times = ambientInShadow(logs);
    if (!times || std::abs(*times - 1.0) < kLeast) return std::nullopt;
    std::vector<ShadowLog> mended;
    for (const ShadowLog* log : logs) {
        mended.push_back(*log);
        for (PointLog& point : mended.back().points)
            point.colour += ambientPart(point, log->scene()) * (1.0 - *times);
    }
    if (!someReadingFits(mended)) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        std::abs(*times) < 1e-6
            ? "The diffuse and the specular light are right; the ambient light is missing at every "
              "point."
            : fmt::format("The diffuse and the specular light are right; the ambient light is "
                          "{:.3g} times what it should be, at every point.",
                          *times));
    finding.hint = ambientHint(*times);
    finding.evidence.emplace_back("ambientTimes", *times);
    return finding;
}

/// Hits nearer than `reachOf(distance of the light)` block, instead of those before the light.
struct Comparison {
    double (*reachOf)(double distance);
    const char* message;
    const char* hint;
};

constexpr std::array kComparisons{
    Comparison{[](double distance) { return std::sqrt(std::max(0.0, distance)); },
               "Objects close to the point cast their shadows, and those farther on the way to the "
               "light cast none: the distance of a hit is compared with something smaller than the "
               "way to the light.",
               "Perhaps a squared distance is compared with one that is not squared, or with a "
               "constant. Compare both plain or both squared: "
               "occluder->distance < (target - start).magnitude(); v.dot(v) is the square of "
               "v.magnitude()."},
    Comparison{[](double) { return 1.0; },
               "Objects close to the point cast their shadows, and those farther on the way to the "
               "light cast none: only what is nearer than 1 does.",
               "Compare the distance of a hit with that of the point that the ray aims at: "
               "occluder->distance < (target - start).magnitude(). With 1 it may be compared only "
               "if the ray's direction is target - start, not normalised."}};

// Unsure if the result depends on the sample's place, which may be anywhere in the light.
Sight sightWithin(const NearestHits& hits, double distance, double radius,
                  const Comparison& comparison) {
    const Sight near = hits.sightUpTo(comparison.reachOf(distance - radius));
    const Sight far = hits.sightUpTo(comparison.reachOf(distance + radius));
    return near == far ? near : Sight::unsure;
}

ShadowLog seenWith(const Comparison& comparison, const ShadowLog& log) {
    ShadowLog seen = log;
    const Surfaces surfaces{log.scene()};
    const Vector3 light = log.scene().pointLights[0].position();
    for (PointLog& point : seen.points)
        for (AimLine& line : point.lines[0])
            line.toLight = sightWithin(surfaces.hitsAlong(line.origin, line.direction),
                                       (light - line.origin).magnitude(), log.settings().lightSize,
                                       comparison);
    return seen;
}

std::optional<Finding> comparedWrongly(const Logs& logs) {
    for (const Comparison& comparison : kComparisons) {
        std::vector<ShadowLog> seen;
        for (const ShadowLog* log : logs)
            seen.push_back(seenWith(comparison, *log));
        if (!someReadingFits(seen)) continue;
        Finding finding = distributedFinding(kShadowWrong, Severity::fail, comparison.message);
        finding.hint = comparison.hint;
        finding.section = "Soft shadows (T2.1), step 1";
        return finding;
    }
    return std::nullopt;
}

// For each point, the factor that scales its light; empty if a single factor does not explain the
// light of some point. Points with rays that rounding decides are left out.
std::vector<PartOfLight> scaledPoints(const Logs& logs) {
    std::vector<PartOfLight> all;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            if (std::ranges::count(point.lines[0], Sight::unsure, &AimLine::toLight) > 0) continue;
            const std::optional<PartOfLight> found = partOfLight(point, *log);
            if (!found) return {};
            all.push_back(*found);
        }
    return all;
}

std::optional<Finding> multipliedPerRay(const Logs& logs) {
    constexpr double kSame = 2e-3;
    constexpr std::size_t kNumbers = 2;  // one number of blocked rays fits any rule
    const std::vector<PartOfLight> points = scaledPoints(logs);
    const auto blocked = [](const PartOfLight& point) { return point.cast - point.open; };
    const auto darkest = std::ranges::max_element(points, {}, blocked);
    // Where little is taken away, a factor for each ray cannot be told from a difference.
    constexpr double kClearlyDarker = 0.8;
    if (darkest == points.end() || blocked(*darkest) == 0 || darkest->part > kClearlyDarker)
        return std::nullopt;
    const double kept =
        std::pow(std::max(0.0, darkest->part), 1.0 / static_cast<double>(blocked(*darkest)));
    if (!(kept < 1.0 - kSame)) return std::nullopt;
    std::set<std::size_t> numbers;
    for (const PartOfLight& point : points) {
        const double expected = std::pow(kept, static_cast<double>(blocked(point)));
        if (std::abs(point.part - expected) > kSame) return std::nullopt;
        if (blocked(point) > 0) numbers.insert(blocked(point));
    }
    if (numbers.size() < kNumbers) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        fmt::format(
            "The share of rays that arrive was expected to scale the light; each blocked ray "
            "multiplies it by {:.3g}, so that where {} of {} are blocked {:.3g} of it is left.",
            kept, blocked(*darkest), darkest->cast, darkest->part));
    finding.hint =
        "Each of n rays counts 1/n of the full light, whatever the others met: count the rays that "
        "arrive and divide by n once, or take share -= 1.0 / n for a blocked ray where you have "
        "share *= something.";
    finding.section = "Soft shadows (T2.1), step 2";
    finding.evidence.emplace_back("keptPerBlockedRay", kept);
    return finding;
}

// Whether the light is the same power of the share at every point: 2 for code that scales it twice.
std::optional<Finding> raisedToAPower(const Logs& logs) {
    constexpr double kSame = 2e-3;
    constexpr std::size_t kNumbers = 3;  // one share fits a power of its own
    const std::vector<PartOfLight> points = scaledPoints(logs);
    const auto middle = std::ranges::min_element(
        points, {}, [](const PartOfLight& point) { return std::abs(point.share() - 0.5); });
    if (middle == points.end() || middle->open == 0 || middle->open == middle->cast ||
        !(middle->part > 0.0))
        return std::nullopt;
    const double power = std::log(middle->part) / std::log(middle->share());
    std::set<std::size_t> numbers;
    for (const PartOfLight& point : points) {
        if (std::abs(point.part - std::pow(point.share(), power)) > kSame) return std::nullopt;
        numbers.insert(point.open);
    }
    if (numbers.size() < kNumbers) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        fmt::format("The share of rays that arrive was expected to scale the light; the share to "
                    "the power {:.3g} does: where {} of {} arrive, {:.3g} of the light is there.",
                    power, middle->open, middle->cast, middle->part));
    finding.hint =
        "Diffuse and specular light are scaled by the share once: not first the light that arrives "
        "and then the sum as well, and no power makes the edge of a shadow softer.";
    finding.section = "Soft shadows (T2.1), step 3";
    finding.evidence.emplace_back("power", power);
    return finding;
}

}  // namespace

std::optional<Finding> explainedShadows(const std::vector<const ShadowLog*>& logs) {
    for (const auto explain :
         {ambientScaledEvenly, comparedWrongly, multipliedPerRay, raisedToAPower})
        if (std::optional<Finding> finding = explain(logs)) return finding;
    return std::nullopt;
}

}  // namespace ticker::tasks
