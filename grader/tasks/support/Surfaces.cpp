#include <grader/tasks/support/Surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ticker::tasks {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Rounding moves a hit by about 1e-13 of the scene's size, and a float copy of the ray by 1e-6. A
// result that changes when spheres grow or shrink by this share is `unsure`.
constexpr double kGraze = 2e-6;

// For a hit nearer than this, rounding decides whether it is the surface that the ray leaves.
constexpr double kAtStart = 1e-9;

}  // namespace

Surfaces::Surfaces(const raytracer::SceneDescription& scene) {
    for (const raytracer::SphereDescription& sphere : scene.spheres)
        balls_.push_back({sphere.centre, sphere.radius});
    for (const raytracer::PlaneDescription& plane : scene.planes)
        sheets_.push_back({plane.point, plane.normal.normalised()});
}

// Distances within rounding of the start become zero.
double Surfaces::nearestHit(const Vector3& origin, const Vector3& direction, double scale) const {
    double nearest = kNever;
    const auto consider = [&](double distance) {
        if (distance > kAtStart)
            nearest = std::min(nearest, distance);
        else if (distance > -kAtStart)
            nearest = 0.0;
    };
    for (const Ball& ball : balls_) {
        const Vector3 towards = ball.centre - origin;
        const double along = towards.dot(direction);
        const double radius = ball.radius * scale;
        const double discriminant = along * along - towards.dot(towards) + radius * radius;
        if (!(discriminant >= 0.0)) continue;
        const double half = std::sqrt(discriminant);
        if (along + half < -kAtStart) continue;
        consider(along - half);
        if (along - half < -kAtStart) consider(along + half);
    }
    for (const Sheet& sheet : sheets_) {
        const double slope = direction.dot(sheet.normal);
        if (std::abs(slope) > 1e-12) consider((sheet.point - origin).dot(sheet.normal) / slope);
    }
    return nearest;
}

Sight Surfaces::sightAlong(const Vector3& origin, const Vector3& direction, double reach) const {
    const double plain = nearestHit(origin, direction, 1.0);
    const bool blocked = plain < reach;
    if (plain == 0.0) return Sight::unsure;
    // An origin inside the grown sphere would see it from inside. Such rays start at its surface,
    // and the true radius decides.
    const double small = nearestHit(origin, direction, 1.0 - kGraze);
    const double large = nearestHit(origin, direction, 1.0 + kGraze);
    const bool starts = std::min(plain, large) < 1e-2;
    if (!starts && ((small < reach) != blocked || (large < reach) != blocked)) return Sight::unsure;
    return blocked ? Sight::blocked : Sight::open;
}

double Surfaces::distanceToNearest(const Vector3& point) const {
    double nearest = kNever;
    for (const Ball& ball : balls_)
        nearest = std::min(nearest, std::abs((point - ball.centre).magnitude() - ball.radius));
    for (const Sheet& sheet : sheets_)
        nearest = std::min(nearest, std::abs((point - sheet.point).dot(sheet.normal)));
    return nearest;
}

const raytracer::Material& materialOf(const raytracer::SceneDescription& scene, int index) {
    const auto at = static_cast<std::size_t>(index);
    if (at < scene.spheres.size()) return scene.spheres[at].material;
    return scene.planes.at(at - scene.spheres.size()).material;
}

}  // namespace ticker::tasks
