#include <grader/tasks/maintick/Exact.h>

#include <fmt/core.h>

#include <utility>

namespace ticker::tasks::maintick {

// Computes the hit from the line's point nearest to the centre. The handout solves a quadratic
// instead, so that no mistake is in both.
std::optional<Meeting> meet(const raytracer::SphereDescription& sphere, const Ray& ray) {
    const double length = ray.direction.magnitude();
    const Vector3 along = ray.direction / length;
    const double middle = (sphere.centre - ray.origin).dot(along);
    const double away = (ray.origin + along * middle - sphere.centre).magnitude();
    if (!(away < sphere.radius)) return std::nullopt;
    const double half = std::sqrt((sphere.radius - away) * (sphere.radius + away));
    const double distance = middle > half ? middle - half : middle + half;
    if (distance <= 0.0) return std::nullopt;
    const Vector3 location = ray.origin + along * distance;
    return Meeting{distance / length, location, (location - sphere.centre) / sphere.radius};
}

std::optional<Meeting> meet(const raytracer::PlaneDescription& plane, const Ray& ray) {
    const Vector3 normal = plane.normal.normalised();
    const double height = (ray.origin - plane.point).dot(normal);
    const double sinking = -ray.direction.dot(normal);
    const double distance = height / sinking;
    if (!(distance > 0.0) || std::isinf(distance)) return std::nullopt;
    return Meeting{distance, ray.evaluateAt(distance), normal};
}

std::string words(const Vector3& v) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
}

std::string words(const ColourRGB& c) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", c.r, c.g, c.b);
}

Finding failure(const FindingText& text, std::string seen, std::string hint) {
    Finding finding = distributedFinding(text, Severity::fail, std::move(seen));
    if (!hint.empty()) finding.hint = std::move(hint);
    return finding;
}

}  // namespace ticker::tasks::maintick
