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

double squareOf(double length) {
    return length * length;
}

// Distances within rounding of the start become zero.
void consider(double distance, double& nearest) {
    if (distance > kAtStart)
        nearest = std::min(nearest, distance);
    else if (distance > -kAtStart)
        nearest = 0.0;
}

// Where a ray enters a ball, or leaves it if it starts inside.
// @param along   Distance to the point nearest to the centre.
// @param beside  Minus the square of that point's distance from the centre.
void considerBall(double along, double beside, double squaredRadius, double& nearest) {
    const double discriminant = beside + squaredRadius;
    if (!(discriminant >= 0.0)) return;
    const double half = std::sqrt(discriminant);
    if (along + half < -kAtStart) return;
    consider(along - half, nearest);
    if (along - half < -kAtStart) consider(along + half, nearest);
}

}  // namespace

Surfaces::Surfaces(const raytracer::SceneDescription& scene) {
    for (const raytracer::SphereDescription& sphere : scene.spheres)
        balls_.push_back({sphere.centre, sphere.radius, squareOf(sphere.radius),
                          squareOf(sphere.radius * (1.0 - kGraze)),
                          squareOf(sphere.radius * (1.0 + kGraze))});
    for (const raytracer::PlaneDescription& plane : scene.planes)
        sheets_.push_back({plane.point, plane.normal.normalised()});
}

NearestHits Surfaces::hitsAlong(const Vector3& origin, const Vector3& direction) const {
    double nearestSheet = kNever;
    for (const Sheet& sheet : sheets_) {
        const double slope = direction.dot(sheet.normal);
        if (std::abs(slope) > 1e-12)
            consider((sheet.point - origin).dot(sheet.normal) / slope, nearestSheet);
    }
    NearestHits hits{nearestSheet, nearestSheet, nearestSheet};
    for (const Ball& ball : balls_) {
        const Vector3 towards = ball.centre - origin;
        const double along = towards.dot(direction);
        const double beside = along * along - towards.dot(towards);
        if (!(beside + ball.largeSquare >= 0.0)) continue;
        considerBall(along, beside, ball.square, hits.plain);
        considerBall(along, beside, ball.smallSquare, hits.small);
        considerBall(along, beside, ball.largeSquare, hits.large);
    }
    return hits;
}

Sight NearestHits::sightUpTo(double reach) const {
    const bool blocked = plain < reach;
    if (plain == 0.0) return Sight::unsure;
    // A ray that starts on a sphere starts inside the grown one and would hit that from inside. For
    // such rays the true radius alone decides.
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
