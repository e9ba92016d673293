#include <grader/decision/distributed/ShadowLog.h>

#include <cmath>
#include <limits>

namespace ticker::decision {
namespace {

using probe::Event;

bool isFinite(const Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::size_t nearestLight(const std::vector<raytracer::PointLight>& lights, const Vector3& origin,
                         const Vector3& direction) {
    std::size_t nearest = 0;
    double best = -2.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const double cosine = (lights[i].position() - origin).normalised().dot(direction);
        if (cosine > best) {
            best = cosine;
            nearest = i;
        }
    }
    return nearest;
}

/// Where a ray starts and where it goes, unit.
struct Course {
    Vector3 origin;
    Vector3 direction;
};

// A ray may be cast the other way round, from the light to the point: it sees the same. It is told
// by its line, which passes the point, and turned round, a small bias off the surface.
Course fromPoint(const Course& course, const probe::LitPoint& point) {
    const Vector3 towards = point.position - course.origin;
    const double along = towards.dot(course.direction);
    constexpr double kFarAway = 0.5;
    constexpr double kPasses = 1.5e-3;
    if (along < kFarAway) return course;
    const Vector3 nearest = course.origin + course.direction * along;
    if ((nearest - point.position).magnitude() > kPasses) return course;
    return {point.position + point.normal * 1e-4, -course.direction};
}

AimLine readLine(const Surfaces& surfaces, const Vector3& centre, const Vector3& origin,
                 const Vector3& direction) {
    AimLine line;
    line.origin = origin;
    line.direction = direction;
    const double along = (centre - origin).dot(direction);
    line.foot = origin + direction * along - centre;
    line.miss = line.foot.magnitude();
    line.endlessly =
        surfaces.sightAlong(origin, direction, std::numeric_limits<double>::infinity());
    // No question has anything in or near a light, so that the distance of the centre and that of
    // the sample decide alike.
    line.toLight = surfaces.sightAlong(origin, direction, (centre - origin).magnitude());
    return line;
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
        const Course course = fromPoint({event.a, event.b / length}, at.point);
        const std::size_t light = nearestLight(lights, course.origin, course.direction);
        at.lines[light].push_back(
            readLine(surfaces, lights[light].position(), course.origin, course.direction));
    }
    if (log.cut && !answer.events.empty() && answer.events.back().ask < log.points.size())
        log.points.resize(answer.events.back().ask);  // the last one may be incomplete
    return log;
}

}  // namespace ticker::decision
