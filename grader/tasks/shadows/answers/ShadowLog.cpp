#include <grader/tasks/shadows/answers/ShadowLog.h>

#include <grader/tasks/support/Finite.h>

#include <questions/RayGeometry.h>

#include <cmath>
#include <limits>

namespace ticker::tasks {
namespace {

namespace questions = raytracer::questions;
using probe::Event;

AimLine readLine(const Surfaces& surfaces, const Vector3& centre, const Vector3& origin,
                 const Vector3& direction) {
    AimLine line;
    line.origin = origin;
    line.direction = direction;
    line.foot = questions::footFrom(centre, {origin, direction});
    line.miss = line.foot.magnitude();
    const NearestHits hits = surfaces.hitsAlong(origin, direction);
    line.endlessly = hits.sightUpTo(std::numeric_limits<double>::infinity());
    // No question has an object that reaches into a light's ball, so that the distance to the
    // centre and the distance to the sample give the same result.
    line.toLight = hits.sightUpTo((centre - origin).magnitude());
    return line;
}

// Whether a ray is that of `line`, cast again from a start farther along: code that meets the
// surface on which its ray starts (shadow acne) goes on behind it. Both rays are one sample.
bool isCastAgain(const AimLine& line, const raytracer::Ray& ray) {
    constexpr double kSame = 1e-12;
    constexpr double kBeside = 2e-3;
    const Vector3 moved = ray.origin - line.origin;
    // A start farther back begins another sample that has the same direction by chance.
    return (ray.direction - line.direction).magnitude() < kSame &&
           moved.dot(ray.direction) > kSame && moved.magnitude() < kBeside;
}

}  // namespace

std::size_t PointLog::lineCount() const {
    std::size_t count = 0;
    for (const std::vector<AimLine>& light : lines)
        count += light.size();
    return count;
}

ShadowLog readShadowLog(const ShadowQuestion& asked, const probe::IlluminateAnswer& answer) {
    ShadowLog log;
    log.asked = &asked;
    log.cut = answer.eventsCut;
    const std::vector<raytracer::PointLight>& lights = asked.question.scene.pointLights;
    for (std::size_t i = 0; i < asked.question.points.size(); ++i) {
        PointLog point;
        point.point = asked.question.points[i];
        point.colour = i < answer.colours.size() ? answer.colours[i] : ColourRGB{};
        point.lines.resize(lights.size());
        point.zones = asked.zones[i];
        log.points.push_back(std::move(point));
    }
    const Surfaces surfaces{asked.question.scene};
    for (const Event& event : answer.events) {
        if (event.kind != Event::Kind::rayCast || event.ask >= log.points.size()) continue;
        if (!isFinite(event.a) || !isFinite(event.b) || lights.empty()) continue;
        const double length = event.b.magnitude();
        if (!(length > 0.0) || !std::isfinite(length)) continue;
        PointLog& at = log.points[event.ask];
        const raytracer::Ray course =
            questions::seenFrom(at.point.position, at.point.normal, {event.a, event.b / length});
        const std::size_t light = questions::nearestLight(lights, course.origin, course.direction);
        std::vector<AimLine>& lines = at.lines[light];
        if (!lines.empty() && isCastAgain(lines.back(), course)) lines.pop_back();
        AimLine& line = lines.emplace_back(
            readLine(surfaces, lights[light].position(), course.origin, course.direction));
        line.isReversed = line.direction.dot(event.b) < 0.0;
    }
    if (log.cut && !answer.events.empty() && answer.events.back().ask < log.points.size())
        log.points.resize(answer.events.back().ask);  // the last one may be incomplete
    return log;
}

}  // namespace ticker::tasks
