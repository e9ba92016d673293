#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/checks/ShadowChecks.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace ticker::tasks {
namespace {

Finding oneChannelAsked(const FindingText& text, const std::string& seen) {
    Finding finding = distributedFinding(
        text, Severity::fail,
        "With colours that have red, green and blue the light is right; where lights or surfaces "
        "have one of these alone, " +
            seen + ": only one channel of the colour was looked at.");
    finding.hint =
        "A light adds nothing only where red, green and blue of its diffuse and specular light are "
        "0, all three. Take out the question whether .r (or .g, .b, or the least of them) is 0: "
        "cast the rays to every light, and add its light, whatever the colour.";
    return finding;
}

}  // namespace

// Every light adds some of its colour at each of these points, so that no reading spares its rays.
std::optional<Finding> checkColourChannels(const ShadowLogs& logs) {
    const RayCounts counts = countRays(logs.pureColours);
    const auto asked = static_cast<std::size_t>(raytracer::RenderSettings{}.shadowRayCount);
    if (counts.fewest >= asked) return std::nullopt;
    Finding finding = oneChannelAsked(
        kShadowTooFewRays,
        counts.fewest == 0
            ? std::string{"some lights get no shadow rays and light nothing"}
            : fmt::format("some lights get {} shadow rays instead of {}", counts.fewest, asked));
    finding.evidence.emplace_back("raysExpected", static_cast<double>(asked));
    finding.evidence.emplace_back("fewestRays", static_cast<double>(counts.fewest));
    return finding;
}

Finding channelsLost() {
    return oneChannelAsked(kShadowWrong, "some of the light is not what it should be");
}

}  // namespace ticker::tasks
