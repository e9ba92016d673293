#include <grader/tasks/shadows/answers/ShadowCache.h>
#include <grader/tasks/shadows/checks/ShadowRayCounts.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ticker::tasks {
namespace {

using raytracer::SceneDescription;

// The surfaces of each object alone.
std::vector<Surfaces> apart(const SceneDescription& scene) {
    std::vector<Surfaces> objects;
    for (const raytracer::SphereDescription& sphere : scene.spheres) {
        SceneDescription alone;
        alone.spheres.push_back(sphere);
        objects.emplace_back(alone);
    }
    for (const raytracer::PlaneDescription& plane : scene.planes) {
        SceneDescription alone;
        alone.planes.push_back(plane);
        objects.emplace_back(alone);
    }
    return objects;
}

/// How many rays a point and a light get: as many as asked for, a multiple, or some more.
class RaysCast {
public:
    /// @param log  At the handout's settings.
    void look(const ShadowLog& log) {
        const auto asked = static_cast<std::size_t>(log.settings().shadowRayCount);
        for (const PointLog& point : log.points)
            for (const std::vector<AimLine>& lines : point.lines) {
                if (lines.size() <= times_ * asked + more_) continue;
                times_ = lines.size() / asked;
                more_ = lines.size() % asked;
            }
    }
    // Of lights in one direction the rays cannot be told apart, and nothing blocks them.
    [[nodiscard]] std::size_t missingAt(const ShadowLog& log,
                                        const std::vector<AimLine>& lines) const {
        if (log.asked->purpose == ShadowQuestion::Purpose::lightsInLine) return 0;
        const auto asked = static_cast<std::size_t>(log.settings().shadowRayCount);
        const std::size_t cast = times_ * asked + more_;
        return cast - std::min(cast, lines.size());
    }

private:
    std::size_t times_ = 1;
    std::size_t more_ = 0;
};

bool isOpen(const AimLine& line) {
    return line.toLight == Sight::open;
}

bool facesLight(const ShadowLog& log, const PointLog& point, std::size_t light) {
    const Vector3 towards = log.scene().pointLights[light].position() - point.point.position;
    return towards.dot(point.point.normal) > 0.0;
}

// A ray to the centre, for a light whose rays are all missing.
AimLine blockedRay(const ShadowLog& log, const PointLog& point, std::size_t light) {
    AimLine line;
    line.origin = point.point.position;
    line.direction =
        (log.scene().pointLights[light].position() - point.point.position).normalised();
    return line;
}

// The ray that a place's missing ones are copied from: any blocked one of the same light.
AimLine missingRay(const ShadowLog& log, const PointLog& point, std::size_t light) {
    const std::vector<AimLine>& lines = point.lines[light];
    const auto blocked = std::ranges::find_if(lines, isBlocked);
    AimLine line = blocked == lines.end() ? blockedRay(log, point, light) : *blocked;
    line.toLight = line.endlessly = Sight::blocked;
    line.isAdded = true;
    return line;
}

/// What the rays of one question say about a shadow cache.
struct Evidence {
    bool contradicted = false;
    std::size_t goesOn = 0;  ///< places with missing rays, and one that arrives after a blocked one
};

class Reader {
public:
    Reader(const ShadowLog& log, const RaysCast& cast)
        : log_(log), cast_(cast), objects_(apart(log.scene())) {}

    Evidence read() && {
        for (const PointLog& point : log_.points)
            for (std::size_t light = 0; light < point.lines.size(); ++light)
                readPlace(point, light);
        return evidence_;
    }

private:
    void readPlace(const PointLog& point, std::size_t light) {
        const std::vector<AimLine>& lines = point.lines[light];
        if (!std::ranges::all_of(lines, isOpen)) anyBlocked_ = true;
        if (lines.empty() && !facesLight(log_, point, light)) return;
        if (cast_.missingAt(log_, lines) == 0) return;
        if (!anyBlocked_ || endsEarly(point, light)) evidence_.contradicted = true;
        const auto blocked = std::ranges::find_if(lines, isBlocked);
        if (std::any_of(blocked, lines.end(), isOpen)) ++evidence_.goesOn;
    }

    // Whether a ray follows a blocked one, and meets the object of that one and of the first.
    [[nodiscard]] bool endsEarly(const PointLog& point, std::size_t light) const {
        const double reach =
            (log_.scene().pointLights[light].position() - point.point.position).magnitude();
        const AimLine* first = nullptr;
        const AimLine* before = nullptr;
        for (const AimLine& line : point.lines[light]) {
            // Rays that run from a light close by to the point are not recognised as such.
            if (biasOf(line, point) > kLargestBias) continue;
            if (before != nullptr && isBlocked(*before) && hides(*before, line, reach) &&
                hides(*first, line, reach))
                return true;
            if (first == nullptr && isBlocked(line)) first = &line;
            before = &line;
        }
        return false;
    }

    // Whether every object that hides the light from `earlier` hides it from `line`, too: which of
    // them was met first depends on the end that the ray starts from. Next to the light a hit may
    // lie behind the sample, whose place is not visible.
    [[nodiscard]] bool hides(const AimLine& earlier, const AimLine& line, double reach) const {
        constexpr double kBeforeTheLight = 0.9;
        const auto blocks = [&](const Surfaces& object, const AimLine& ray) {
            return object.sightAlong(ray.origin, ray.direction, kBeforeTheLight * reach) ==
                   Sight::blocked;
        };
        bool any = false;
        for (const Surfaces& object : objects_) {
            if (!blocks(object, earlier)) continue;
            if (!blocks(object, line)) return false;
            any = true;
        }
        return any;
    }

    const ShadowLog& log_;
    const RaysCast& cast_;
    std::vector<Surfaces> objects_;
    Evidence evidence_;
    bool anyBlocked_ = false;  // some ray so far, of any light
};

ShadowLog filledUp(ShadowLog log, const RaysCast& cast) {
    for (PointLog& point : log.points)
        for (std::size_t light = 0; light < point.lines.size(); ++light) {
            std::vector<AimLine>& lines = point.lines[light];
            if (lines.empty() && !facesLight(log, point, light)) continue;
            const std::size_t missing = cast.missingAt(log, lines);
            if (missing > 0) lines.insert(lines.end(), missing, missingRay(log, point, light));
        }
    return log;
}

}  // namespace

ShadowLog withCachedRays(ShadowLog log) {
    RaysCast cast;
    cast.look(log);
    return filledUp(std::move(log), cast);
}

std::optional<std::vector<ShadowLog>> withCachedRays(const std::vector<ShadowLog>& logs) {
    // One such place may come about by rays that are spared for another reason.
    constexpr std::size_t kEnough = 4;
    RaysCast cast;
    for (const ShadowLog& log : logs)
        if (log.asked->purpose == ShadowQuestion::Purpose::oneLight) cast.look(log);
    std::size_t goesOn = 0;
    for (const ShadowLog& log : logs) {
        const Evidence evidence = Reader{log, cast}.read();
        if (evidence.contradicted) return std::nullopt;
        goesOn += evidence.goesOn;
    }
    if (goesOn < kEnough) return std::nullopt;
    std::vector<ShadowLog> whole;
    whole.reserve(logs.size());
    for (const ShadowLog& log : logs)
        whole.push_back(filledUp(log, cast));
    return whole;
}

}  // namespace ticker::tasks
