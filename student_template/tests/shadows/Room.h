#ifndef SHADOWS_ROOM_H
#define SHADOWS_ROOM_H

#include <questions/RayGeometry.h>
#include <raytracer/geometry/Material.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstddef>

namespace raytracer::tests::shadows {

// A floor at y = -2, a ball above it, and a light above the ball. Colours differ in each channel,
// so that ambient, diffuse and specular light cannot be mistaken for each other.
inline constexpr Vector3 kLight{0.3, 4.0, 9.0};
inline constexpr Vector3 kBall{0.3, 1.0, 7.0};
// Where the line from the light through the centre of the ball meets the floor.
inline constexpr Vector3 kFoot{0.3, -2.0, 5.0};
constexpr double kBallRadius = 0.7;
inline constexpr Vector3 kUp{0.0, 1.0, 0.0};
inline constexpr Vector3 kEye{0.0, 0.0, 0.0};
inline constexpr ColourRGB kAmbient{0.11, 0.17, 0.23};

[[nodiscard]] Material floorMaterial();
[[nodiscard]] SceneDescription emptyRoom();
[[nodiscard]] SceneDescription roomWithBall();

/// The point of the floor `right` world units to the right of `kFoot`, the darkest point.
[[nodiscard]] Vector3 floorAt(double right);

/// The point of the floor from which the light's centre appears beside the ball, `clear` world
/// units (at the light) from its rim; negative: behind the ball.
[[nodiscard]] Vector3 floorWhereLightIsClearBy(double clear);

/// Colour of a point of the floor in full shadow.
[[nodiscard]] ColourRGB ambientOnly();

/// Contribution of a light of the scene to a point of the floor without shadow.
[[nodiscard]] questions::PhongTerms unshadowed(const SceneDescription& scene, std::size_t light,
                                               const Vector3& point);

/// The share of the light that arrives, according to a colour: 0 in full shadow, 1 in full light.
[[nodiscard]] double shareOf(const ColourRGB& colour, const Vector3& point);

}  // namespace raytracer::tests::shadows

#endif
