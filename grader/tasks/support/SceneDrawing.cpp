#include <grader/tasks/support/SceneDrawing.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {

RayDrawing drawScene(const raytracer::SceneDescription& scene, double lightSize) {
    RayDrawing drawing;
    for (const raytracer::SphereDescription& sphere : scene.spheres)
        drawing.spheres.push_back({fmt::format("sphere {}", drawing.spheres.size() + 1),
                                   drawn(sphere.centre), sphere.radius});
    for (const raytracer::PlaneDescription& plane : scene.planes)
        drawing.planes.push_back({fmt::format("plane {}", drawing.planes.size() + 1),
                                  drawn(plane.point), drawn(plane.normal)});
    for (const raytracer::PointLight& light : scene.pointLights)
        drawing.lights.push_back({fmt::format("light {}", drawing.lights.size() + 1),
                                  drawn(light.position()), lightSize});
    return drawing;
}

Vector3 endInScene(const raytracer::SceneDescription& scene, const Vector3& origin,
                   const Vector3& direction, double reach) {
    constexpr double kStart = 1e-3;  // not the surface that the ray starts on
    for (const raytracer::SphereDescription& sphere : scene.spheres) {
        const Vector3 to = sphere.centre - origin;
        const double along = to.dot(direction);
        const double inside = along * along - to.dot(to) + sphere.radius * sphere.radius;
        const double distance = along - std::sqrt(std::max(0.0, inside));
        if (inside >= 0.0 && distance > kStart) reach = std::min(reach, distance);
    }
    for (const raytracer::PlaneDescription& plane : scene.planes) {
        const double distance =
            (plane.point - origin).dot(plane.normal) / direction.dot(plane.normal);
        if (distance > kStart) reach = std::min(reach, distance);
    }
    return origin + direction * reach;
}

}  // namespace ticker::tasks
