#include <grader/tasks/shadows/answers/ShadowCache.h>

#include <algorithm>
#include <cmath>
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

/// How many rays a point and a light get: as many as asked for, or a multiple.
class RaysCast {
public:
    /// @param log  At the handout's settings.
    void look(const ShadowLog& log) {
        for (const PointLog& point : log.points)
            for (const std::vector<AimLine>& lines : point.lines)
                times_ = std::max(
                    times_, static_cast<double>(lines.size()) / log.settings().shadowRayCount);
    }
    // Of lights in one direction the rays cannot be told apart, and nothing blocks them.
    [[nodiscard]] std::size_t missingAt(const ShadowLog& log,
                                        const std::vector<AimLine>& lines) const {
        if (log.asked->purpose == ShadowQuestion::Purpose::lightsInLine) return 0;
        const auto cast =
            static_cast<std::size_t>(std::lround(times_ * log.settings().shadowRayCount));
        return cast - std::min(cast, lines.size());
    }

private:
    double times_ = 1.0;
};

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
        const Vector3& centre = log_.scene().pointLights[light].position();
        bool arrivesAfter = false;
        const AimLine* before = nullptr;
        for (const AimLine& line : lines) {
            if (line.toLight != Sight::open) anyBlocked_ = true;
            if (before != nullptr && isBlocked(*before)) {
                if (isBlocked(line) && shareABlocker(*before, line, centre))
                    evidence_.contradicted = true;
                if (line.toLight == Sight::open) arrivesAfter = true;
            }
            before = &line;
        }
        if (lines.empty() && !facesLight(log_, point, light)) return;
        if (cast_.missingAt(log_, lines) == 0) return;
        if (!anyBlocked_) evidence_.contradicted = true;
        if (arrivesAfter) ++evidence_.goesOn;
    }

    // Whether the object that `first` meets before the light surely blocks `second` as well.
    [[nodiscard]] bool shareABlocker(const AimLine& first, const AimLine& second,
                                     const Vector3& centre) const {
        const double reach = (centre - first.origin).magnitude();
        const Surfaces* nearest = nullptr;
        double distance = reach;
        for (const Surfaces& object : objects_) {
            const double hit = object.hitsAlong(first.origin, first.direction).plain;
            if (!(hit < distance)) continue;
            distance = hit;
            nearest = &object;
        }
        return nearest != nullptr &&
               nearest->sightAlong(second.origin, second.direction, reach) == Sight::blocked;
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
