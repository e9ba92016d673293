#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

// Distance between two lines if they pass each other near the light; a large number otherwise.
double distanceNear(const AimLine& a, const AimLine& b, const Vector3& light, double radius) {
    const Vector3 across = a.direction.cross(b.direction);
    const double sine = across.magnitude();
    if (sine < 1e-3) return 1e9;
    const Vector3 between = b.origin - a.origin;
    const double along = between.cross(b.direction).dot(across) / (sine * sine);
    const Vector3 nearest = a.origin + a.direction * along;
    if ((nearest - light).magnitude() > 4.0 * radius) return 1e9;
    return std::abs(between.dot(across)) / sine;
}

// Equal aims at two points: the lines meet, ray by ray in the order of casting. Two independent
// lines come within 2e-3 at radius 0.4 with a chance below 0.02, all ten pairs below 1e-16.
bool sameAims(const PointLog& a, const PointLog& b, const Vector3& light, double radius) {
    const std::vector<AimLine>& left = a.lines[0];
    const std::vector<AimLine>& right = b.lines[0];
    if (left.size() != right.size() || left.empty()) return false;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const double slack =
            1e-6 + 2.0 * std::min(std::max(biasOf(left[i], a), biasOf(right[i], b)), 1e-3);
        if (distanceNear(left[i], right[i], light, radius) > slack) return false;
    }
    return true;
}

// Compares the first point with all others that are not too close to it.
bool sameAimsEverywhere(const ShadowLog& log) {
    if (log.points.empty()) return false;
    const Vector3 light = log.scene().pointLights[0].position();
    std::size_t compared = 0;
    for (const PointLog& point : log.points) {
        const double apart = (point.point.position - log.points[0].point.position).magnitude();
        if (apart < 0.05) continue;
        if (!sameAims(log.points[0], point, light, log.settings().lightSize)) return false;
        ++compared;
    }
    return compared >= 8;
}

/// Whether the colours fit if the light is divided by another number than that of its rays.
bool fitsDividedBy(std::size_t divisor, ShadowLog log, std::size_t rays) {
    const double times = static_cast<double>(divisor) / static_cast<double>(rays);
    for (PointLog& point : log.points) {
        const ColourRGB ambient = ambientPart(point, log.scene());
        point.colour = ambient + (point.colour - ambient) * times;
    }
    return fitsAnyReading(log);
}

/// What is wrong with the light if as many rays as asked for, or more, were cast. Empty if nothing
/// is, or if the cause is a hard-coded number of rays, which another check reports.
std::string oddLight(const ShadowLog& log, const RayCounts& counts) {
    const auto atHandout = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    const auto asked = static_cast<std::size_t>(log.settings().shadowRayCount);
    if (counts.fewest < asked || counts.most >= atHandout || fitsAnyReading(log)) return {};
    if (counts.fewest > asked) return " and divides the light by another number";
    const bool isTypedIn = counts.most == asked && fitsDividedBy(atHandout, log, asked);
    return isTypedIn ? "" : ", but the light is not the share of them that arrive";
}

}  // namespace

ShadowLogs::ShadowLogs(const std::vector<ShadowLog>& logs) {
    const auto listOf = [this](Purpose purpose) -> std::vector<const ShadowLog*>& {
        switch (purpose) {
            case Purpose::oneLight:
                return oneLight;
            case Purpose::severalLights:
                return severalLights;
            case Purpose::eightLights:
                return eightLights;
            case Purpose::beyondLight:
                return beyondLight;
            case Purpose::planeShadow:
                return planeShadow;
            case Purpose::farLight:
                return farLight;
            case Purpose::lightBehind:
                return lightBehind;
            case Purpose::inLine:
                return inLine;
            case Purpose::otherSettings:
                return otherSettings;
            case Purpose::contact:
                return contact;
            case Purpose::lowLight:
                return lowLight;
            case Purpose::nearLight:
                return nearLight;
            case Purpose::pureColours:
                return pureColours;
            case Purpose::oddCount:
                return oddCount;
            case Purpose::faintLight:
                return faintLight;
            case Purpose::closeLight:
                return closeLight;
            case Purpose::backSide:
                return backSide;
            case Purpose::oneTerm:
                return oneTerm;
            case Purpose::mirror:
                return mirror;
            case Purpose::enclosed:
                return enclosed;
            case Purpose::betweenLights:
                return betweenLights;
            case Purpose::behindAlone:
                return behindAlone;
            case Purpose::behindAfter:
                return behindAfter;
            case Purpose::lightsInLine:
                return lightsInLine;
            case Purpose::oneRay:
                return oneRay;
            case Purpose::manyRays:
                return manyRays;
            case Purpose::mixed:
                return mixed;
            case Purpose::mixedNear:
                return mixedNear;
            case Purpose::horizon:
                break;
        }
        return horizon;
    };
    for (const ShadowLog& log : logs)
        listOf(log.asked->purpose).push_back(&log);
}

std::vector<const ShadowLog*> ShadowLogs::atHandoutSettings() const {
    std::vector<const ShadowLog*> all;
    for (const auto* some : {&oneLight, &severalLights, &beyondLight, &planeShadow, &farLight,
                             &lightBehind, &inLine, &lowLight, &nearLight, &pureColours})
        all.insert(all.end(), some->begin(), some->end());
    return all;
}

std::optional<Finding> checkFinite(const ShadowLogs& logs) {
    for (const ShadowLog* log : logs.atHandoutSettings())
        for (const PointLog& point : log->points)
            if (!std::isfinite(point.colour.r + point.colour.g + point.colour.b))
                return distributedFinding(kShadowWrong, Severity::fail,
                                          "A colour was expected from illuminate; at an ordinary "
                                          "point it gave NaN or infinity.");
    return std::nullopt;
}

std::optional<Finding> checkFixedSamples(const ShadowLogs& logs) {
    if (logs.oneLight.empty()) return std::nullopt;
    for (const ShadowLog* log : logs.oneLight)
        if (!sameAimsEverywhere(*log)) return std::nullopt;
    const std::size_t distinct = distinctRays(logs.oneLight[0]->points[0].lines[0]);
    Finding finding = distributedFinding(
        kShadowFixedSamples, distinct <= 2 ? Severity::fail : Severity::warn,
        fmt::format("New random points of the light were expected for every point that is lit; all "
                    "of them get the same ones, whose number is {}{}.",
                    distinct, distinct <= 2 ? "" : ", so that the edges of shadows come in steps"));
    if (distinct == 1)
        finding.hint =
            "Draw a new point for every ray, inside of the loop over the rays: none kept from "
            "before it, none static, and no generator that starts again there. With rand() divide "
            "as double: rand() / RAND_MAX, of whole numbers, is 0.";
    finding.evidence.emplace_back("distinctAims", static_cast<double>(distinct));
    return finding;
}

// The limit is twice the number of rays of one point, since feet next to the edge of a cell count
// twice.
std::optional<Finding> checkSmallPool(const AimVerdict& aims) {
    const auto asked = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    if (aims.lines == 0 || aims.distinct > 2 * asked) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowFixedSamples, Severity::warn,
        fmt::format("New random points of the light were expected for every point that is lit; of "
                    "{} rays about {} have an aim of their own.",
                    aims.lines, aims.distinct));
    finding.hint =
        "Draw new points in every call: not from a table that is filled once, nor from a generator "
        "that a number of the place, as P.x, seeds anew.";
    finding.evidence.emplace_back("distinctAims", static_cast<double>(aims.distinct));
    return finding;
}

std::optional<Finding> checkDirectionOffset(const ShadowLogs& logs) {
    const double near = widestMiss({logs.oneLight.begin(), logs.oneLight.begin() + 1});
    const double far = widestMiss(logs.farLight);
    const double radius = raytracer::RenderSettings{}.lightSize;
    // One kind of light stands 6 units away, the other more than 100: the radius of a light of
    // constant angular size grows by a factor above 15, that of a ball not at all.
    if (far < 2.0 * radius || far < 5.0 * near) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowDirectionOffset, Severity::fail,
        fmt::format("Shadow rays were expected to pass within {} of the light's centre whatever "
                    "its distance; at a light 6 units away they pass within {:.2f}, at one more "
                    "than 100 away within {:.1f}: the light grows with the distance.",
                    radius, near, far));
    finding.evidence.emplace_back("widestNear", near);
    finding.evidence.emplace_back("widestFar", far);
    return finding;
}

// If fewer rays than asked for are cast, their number is not hard-coded, since more were cast at
// the handout's settings. More rays are right if the light is divided by their number. If they are
// as many as the handout's, another check reports a hard-coded number.
std::optional<Finding> checkOddCount(const ShadowLogs& logs) {
    const auto atHandout = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    for (const ShadowLog* log : logs.oddCount) {
        const RayCounts counts = countRays({log});
        const auto asked = static_cast<std::size_t>(log->settings().shadowRayCount);
        const bool tooFew = counts.fewest < asked;
        const std::string light = oddLight(*log, counts);
        if (!tooFew && light.empty()) continue;
        Finding finding = distributedFinding(
            tooFew ? kShadowTooFewRays : kShadowWrong, Severity::fail,
            fmt::format("With {} shadow rays all is right; asked for {}, an odd number, illuminate "
                        "casts {}{}.",
                        atHandout, asked, counts.fewest, light));
        finding.hint =
            "Half of an odd number is rounded down as an int, so that rays in pairs are one too "
            "few; so are other groups where some rays are left over, and tenths of ten rays are no "
            "tenths of seven. Cast settings().shadowRayCount rays whatever that number is, or "
            "more, and divide, as double, by the number of rays that you cast.";
        finding.section = "Soft shadows (T2.1), step 1";
        finding.evidence.emplace_back("raysAsked", static_cast<double>(asked));
        finding.evidence.emplace_back("raysSeen", static_cast<double>(counts.fewest));
        return finding;
    }
    return std::nullopt;
}

}  // namespace ticker::tasks
