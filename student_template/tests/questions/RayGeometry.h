#ifndef QUESTIONS_RAYGEOMETRY_H
#define QUESTIONS_RAYGEOMETRY_H

#include <raytracer/geometry/Material.h>
#include <raytracer/math/Ray.h>
#include <raytracer/scene/PointLight.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace raytracer::questions {

// Quantities for judging tasks T2.1 and T2.2, shared by the public tests and the grader. Rays are
// judged by their lines, since the length of a direction does not tell which point on the line the
// ray aims at.

/// Vector from a point to the nearest point of the ray's line.
[[nodiscard]] Vector3 footFrom(const Vector3& point, const Ray& ray);

/// The light of a shadow ray: the one that it passes at the smallest angle.
/// @param direction  Unit length.
[[nodiscard]] std::size_t nearestLight(const std::vector<PointLight>& lights, const Vector3& origin,
                                       const Vector3& direction);

/// A shadow ray as cast from the lit point. A ray that was cast from the light to the point meets
/// the same objects and is reversed; every other ray is returned unchanged.
/// @param position  The lit point.
/// @param normal    Its unit normal.
/// @param ray       Its direction has unit length.
[[nodiscard]] Ray seenFrom(const Vector3& position, const Vector3& normal, const Ray& ray);

/// Contribution of one light to a point without shadow.
struct PhongTerms {
    ColourRGB diffuse;
    ColourRGB specular;

    [[nodiscard]] ColourRGB sum() const { return diffuse + specular; }
};

/// Phong's model with the kit's conventions: light falls off by 1 / (4 pi d^2), and the light's
/// colour enters the specular term twice.
///
/// @param normal    Unit.
/// @param toViewer  Unit.
/// @param toLight   Unit.
/// @param distance  Distance for the falloff, world units.
[[nodiscard]] PhongTerms phongTerms(const Material& material, const PointLight& light,
                                    const Vector3& normal, const Vector3& toViewer,
                                    const Vector3& toLight, double distance);

}  // namespace raytracer::questions

#endif
