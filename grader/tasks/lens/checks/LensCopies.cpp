#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace ticker::tasks {
namespace {

// Whether the rays of a pixel met different colours, so that its mean is that of no other pixel.
bool hasTwoColours(const LensPixel& pixel) {
    const auto valueOf = [](const LensRay& ray) { return ray.value.value_or(ray.ambient); };
    return std::ranges::any_of(pixel.rays, [&](const LensRay& ray) {
        return !(valueOf(ray) == valueOf(pixel.rays.front()));
    });
}

// One of the eight pixels around `index` that has rays and the same colour; null if none.
const LensPixel* copiedBy(const LensLog& log, int index) {
    const raytracer::RenderSettings& settings = log.asked->settings;
    const LensPixel& copy = log.pixels[static_cast<std::size_t>(index)];
    const int column = index % settings.width;
    const int row = index / settings.width % settings.height;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, settings.height - 1); ++y)
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, settings.width - 1); ++x) {
            const auto at = static_cast<std::size_t>(
                (copy.repetition * settings.height + y) * settings.width + x);
            if (at >= log.pixels.size() || log.pixels[at].rays.empty()) continue;
            if (log.pixels[at].colour == copy.colour) return &log.pixels[at];
        }
    return nullptr;
}

}  // namespace

std::optional<Finding> checkCopies(const LensLog& log) {
    if (log.cut) return std::nullopt;
    int first = 0;
    int copies = 0;
    bool certain = false;
    for (int i = 0; i < static_cast<int>(log.pixels.size()); ++i) {
        if (!log.pixels[static_cast<std::size_t>(i)].rays.empty()) continue;
        const LensPixel* source = copiedBy(log, i);
        if (source == nullptr) return std::nullopt;
        certain = certain || hasTwoColours(*source);
        if (copies++ == 0) first = i;
    }
    if (!certain) return std::nullopt;
    Finding finding = distributedFinding(
        kDofTooFewRays, Severity::fail,
        fmt::format("{} rays for each pixel were expected; {} of {} pixels, the first in {}, have "
                    "none and show the colour of a neighbour.",
                    log.asked->settings.dofRayCount, copies, log.pixels.size(),
                    placeOf(log, first)));
    finding.hint +=
        " Take out what leaves out pixels (a return, or a step of 2) and what copies others into "
        "their place.";
    return finding;
}

}  // namespace ticker::tasks
