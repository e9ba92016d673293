#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>
#include <grader/tasks/shadows/checks/HighlightCheck.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ticker::tasks {
namespace {

Vector3 asVector(const ColourRGB& colour) {
    return {colour.r, colour.g, colour.b};
}

/// Share of the light that should arrive; empty if it is unknown.
std::optional<double> shareAt(const PointLog& point) {
    const std::vector<AimLine>& lines = point.lines[0];
    if (lines.empty()) {
        if (point.zones[0] == Zone::penumbra) return std::nullopt;
        return point.zones[0] == Zone::lit ? 1.0 : 0.0;
    }
    const auto count = [&](Sight sight) {
        return std::count_if(lines.begin(), lines.end(),
                             [&](const AimLine& line) { return line.toLight == sight; });
    };
    if (count(Sight::unsure) > 0) return std::nullopt;
    return static_cast<double>(count(Sight::open)) / static_cast<double>(lines.size());
}

/// Diffuse light and highlight at one point, as shares of their largest values, and the share of
/// the highlight that this viewer should see.
struct Parts {
    double diffuse = 0.0;
    double highlight = 0.0;
    double fullHighlight = 0.0;
    double alpha = 1.0;
    double toLight = 0.0;  ///< length of the vector, world units; so is the next one
    double toViewer = 0.0;

    /// Factor by which the cosine in the highlight is too large.
    [[nodiscard]] double stretch(double expected) const {
        return std::pow(highlight / expected, 1.0 / alpha);
    }
};

// Separates diffuse light and highlight: two unknowns in three channels. Empty if their colours are
// too much alike, or if the two do not explain the third channel.
std::optional<Parts> partsSeen(const PointLog& point, const ShadowLog& log) {
    constexpr double kUnlike = 0.01;
    constexpr double kRest = 1e-3;
    const raytracer::PointLight& light = log.scene().pointLights[0];
    const Vector3 towards = light.position() - point.point.position;
    const double distance = towards.magnitude();
    const auto termsFor = [&](const Vector3& toViewer) {
        return phongTerms(materialOf(log.scene(), point.point.object), light, point.point.normal,
                          toViewer, towards / distance, distance);
    };
    const Vector3 mirrored = (towards / distance).reflectIn(point.point.normal);
    const PhongTerms terms = termsFor((point.point.viewer - point.point.position).normalised());
    const Vector3 diffuse = asVector(terms.diffuse);
    const Vector3 highlight = asVector(termsFor(mirrored).specular);
    const Vector3 seen = asVector(point.colour - ambientPart(point, log.scene()));
    const double across = diffuse.cross(highlight).magnitude();
    if (!(across > kUnlike * diffuse.magnitude() * highlight.magnitude())) return std::nullopt;
    const Vector3 normal = diffuse.cross(highlight) / across;
    if (std::abs(seen.dot(normal)) > kRest * std::max(seen.magnitude(), diffuse.magnitude()))
        return std::nullopt;
    return Parts{seen.cross(highlight).dot(normal) / across,
                 diffuse.cross(seen).dot(normal) / across,
                 asVector(terms.specular).magnitude() / highlight.magnitude(),
                 materialOf(log.scene(), point.point.object).phongAlpha,
                 distance,
                 (point.point.viewer - point.point.position).magnitude()};
}

/// Whether the code uses the unnormalised vector to the light, or to the viewer, at every point.
struct Lengths {
    bool light = true;
    bool viewer = true;

    // A dim highlight carries no information.
    void look(const Parts& seen, double expected) {
        constexpr double kDim = 1e-3;
        constexpr double kSame = 0.01;
        if (expected < kDim) return;
        const double stretch = seen.stretch(expected);
        light = light && std::abs(stretch / seen.toLight - 1.0) < kSame;
        viewer = viewer && std::abs(stretch / seen.toViewer - 1.0) < kSame;
    }
    void explain(Finding& finding) const {
        if (light == viewer) return;
        finding.message += light
                               ? " It is as with a direction to the light that is as long as the "
                                 "way there."
                               : " It is as with a direction to the viewer that is as long as the "
                                 "way there.";
        finding.hint = light ? "Reflect the unit vector to the light: (light.position() - "
                               "P).normalised().reflectIn(N), not (light.position() - "
                               "P).reflectIn(N). The direction to the viewer is right."
                             : "The direction to the viewer has unit length: (O - P).normalised(). "
                               "That to the light is right.";
    }
};

/// Whether the highlight is the same number of times what it should be, at every point.
struct Times {
    std::optional<double> factor = {};
    bool even = true;

    void look(const Parts& seen, double expected) {
        constexpr double kDim = 1e-3;
        constexpr double kSame = 0.01;
        if (expected < kDim) {
            even = even && std::abs(seen.highlight) < kDim * kSame + 1e2 * expected;
            return;
        }
        const double times = seen.highlight / expected;
        if (!factor) factor = times;
        even = even && std::abs(times - *factor) <= kSame * std::max(1.0, std::abs(*factor));
    }
    void explain(Finding& finding) const {
        if (!even || !factor) return;
        const double rays = raytracer::RenderSettings{}.shadowRayCount;
        const auto isAbout = [&](double times) { return std::abs(*factor / times - 1.0) < 0.02; };
        finding.evidence.emplace_back("highlightTimes", *factor);
        if (std::abs(*factor) < 0.01) {
            finding.message += " It is missing everywhere.";
            return;
        }
        finding.message +=
            fmt::format(" It is {:.3g} times what it should be, at every point.", *factor);
        if (isAbout(rays))
            finding.hint =
                "The highlight is the sum over n rays, not their mean: divide it by their number, "
                "as the diffuse light is: (diffuse + specular) / n for each ray that arrives, or "
                "(diffuse + specular) * share once.";
        else if (isAbout(1.0 / rays))
            finding.hint =
                "The highlight is divided by the number of rays twice: it is divided once, as the "
                "diffuse light is: (diffuse + specular) * share.";
    }
};

}  // namespace

std::optional<Finding> highlightAlone(const std::vector<const ShadowLog*>& logs) {
    constexpr std::size_t kEnough = 8;
    constexpr double kRight = 0.01;
    std::size_t points = 0;
    Parts worst;
    double expected = 0.0;
    Lengths lengths;
    Times times;
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points) {
            const std::optional<double> share = shareAt(point);
            if (!share) continue;
            const std::optional<Parts> seen = partsSeen(point, *log);
            if (!seen) return std::nullopt;
            // In a sum with a highlight of 1e14 only the last digits are left for the diffuse
            // light.
            const double rounding = 1e-13 * std::abs(seen->highlight);
            if (std::abs(seen->diffuse - *share) > kRight + rounding) return std::nullopt;
            ++points;
            const double here = *share * seen->fullHighlight;
            lengths.look(*seen, here);
            times.look(*seen, here);
            if (std::abs(seen->highlight - here) <= std::abs(worst.highlight - expected)) continue;
            worst = *seen;
            expected = here;
        }
    if (points < kEnough || std::abs(worst.highlight - expected) < kRight) return std::nullopt;
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "The ambient and the diffuse light are right, and shadows are soft; the highlight (the "
        "specular term) is not what was expected.");
    finding.hint =
        "Both directions in the highlight have unit length: (O - P).normalised() to the viewer, "
        "and the direction to the light reflected in N. Their product, at least 0, is raised to "
        "object.phongAlpha() and multiplied by object.phongKS(). The share of the light that "
        "arrives scales this term once, as it does the diffuse one.";
    lengths.explain(finding);
    times.explain(finding);
    finding.evidence.emplace_back("highlightExpected", expected);
    finding.evidence.emplace_back("highlightSeen", worst.highlight);
    return finding;
}

std::optional<Finding> highlightOfLowLight(const std::vector<const ShadowLog*>& logs) {
    std::optional<Finding> finding = highlightAlone(logs);
    if (!finding) return std::nullopt;
    finding->message =
        "From the side of a low light no highlight was expected, since R.V is below 0 there; the "
        "highlight (the specular term) is not 0.";
    finding->hint =
        "Where R.V is negative there is no highlight: take std::max(0.0, R.dot(V)) before "
        "std::pow, and no absolute value. An even power of a negative number is positive.";
    return finding;
}

}  // namespace ticker::tasks
