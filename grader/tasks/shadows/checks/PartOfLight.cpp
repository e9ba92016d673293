#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/checks/PartOfLight.h>

namespace ticker::tasks {

std::optional<PartOfLight> partOfLight(const PointLog& point, const ShadowLog& log) {
    constexpr double kSame = 1e-3;
    PartOfLight found;
    for (const AimLine& line : point.lines[0]) {
        if (line.toLight == Sight::unsure) return std::nullopt;
        if (line.toLight == Sight::open) ++found.open;
        ++found.cast;
    }
    if (found.cast == 0) return std::nullopt;
    const ColourRGB ambient = ambientPart(point, log.scene());
    const ColourRGB full = inFullLight(point, log.scene()) - ambient;
    const ColourRGB seen = point.colour - ambient;
    if (!(full.r + full.g + full.b > 0.0)) return std::nullopt;
    found.part = (seen.r + seen.g + seen.b) / (full.r + full.g + full.b);
    if (!near(seen, full * found.part, full * kSame)) return std::nullopt;
    return found;
}

}  // namespace ticker::tasks
