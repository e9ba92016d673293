#ifndef QUESTIONS_RAYGEOMETRY_H
#define QUESTIONS_RAYGEOMETRY_H

#include <raytracer/geometry/Material.h>
#include <raytracer/math/Ray.h>
#include <raytracer/scene/PointLight.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace raytracer::questions {

// What tasks T2.1 and T2.2 are judged by, in the public tests and in the grader alike. Of a ray
// only its line counts: how long the direction was says nothing about what it was aimed at.

/// From a point to the nearest point of the ray's line.
[[nodiscard]] Vector3 footFrom(const Vector3& point, const Ray& ray);

/// The light that a shadow ray is cast for: the one that it passes at the smallest angle.
/// @param direction  Unit length.
[[nodiscard]] std::size_t nearestLight(const std::vector<PointLight>& lights, const Vector3& origin,
                                       const Vector3& direction);

/// A shadow ray as it would be cast from the point: one that was cast the other way round, from the
/// light, sees the same and is turned round.
[[nodiscard]] Ray seenFrom(const Vector3& position, const Vector3& normal, const Ray& ray);

/// What one light adds to a point that nothing shadows.
struct PhongTerms {
    ColourRGB diffuse;
    ColourRGB specular;

    [[nodiscard]] ColourRGB sum() const { return diffuse + specular; }
};

/// Phong's model with the kit's conventions: light falls by 1 / (4 pi d^2), the light's colour
/// enters the specular term twice.
///
/// @param normal    Unit.
/// @param toViewer  Unit.
/// @param toLight   Unit.
/// @param distance  Over which the light falls off, world units.
[[nodiscard]] PhongTerms phongTerms(const Material& material, const PointLight& light,
                                    const Vector3& normal, const Vector3& toViewer,
                                    const Vector3& toLight, double distance);

}  // namespace raytracer::questions

#endif
