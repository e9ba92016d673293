#include <questions/RayGeometry.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raytracer::questions {

Vector3 footFrom(const Vector3& point, const Ray& ray) {
    const Vector3 direction = ray.direction.normalised();
    const double along = (point - ray.origin).dot(direction);
    return ray.origin + direction * along - point;
}

std::size_t nearestLight(const std::vector<PointLight>& lights, const Vector3& origin,
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

Ray seenFrom(const Vector3& position, const Vector3& normal, const Ray& ray) {
    const double along = (position - ray.origin).dot(ray.direction);
    constexpr double kFarAway = 0.5;
    constexpr double kPasses = 1.5e-3;
    constexpr double kOffSurface = 1e-4;
    if (along < kFarAway) return ray;
    const Vector3 nearest = ray.origin + ray.direction * along;
    if ((nearest - position).magnitude() > kPasses) return ray;
    // The reversed ray starts on its own line, since near the edge of an object a shifted line may
    // have another result. If the light is below the horizon, such a start would lie below the
    // surface.
    const Vector3 back = -ray.direction;
    if (back.dot(normal) > 0.0) return {nearest + back * kOffSurface, back};
    return {position + normal * kOffSurface, back};
}

PhongTerms phongTerms(const Material& material, const PointLight& light, const Vector3& normal,
                      const Vector3& toViewer, const Vector3& toLight, double distance) {
    const ColourRGB arriving =
        light.colour() * (light.intensity() / (4.0 * std::numbers::pi * distance * distance));
    const double facing = std::max(0.0, normal.dot(toLight));
    const double mirrored = std::max(0.0, toLight.reflectIn(normal).dot(toViewer));
    return {
        material.colour * arriving * (material.phongKD * facing),
        light.colour() * arriving * (material.phongKS * std::pow(mirrored, material.phongAlpha))};
}

}  // namespace raytracer::questions
