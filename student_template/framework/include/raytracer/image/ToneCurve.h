#ifndef RAYTRACER_IMAGE_TONECURVE_H
#define RAYTRACER_IMAGE_TONECURVE_H

#include <raytracer/image/ColourRGB.h>

#include <array>
#include <cstdint>

namespace raytracer {

/// The byte of a linear colour component in an 8-bit picture:
/// p = max(c, 0)^1.3, d = p / (p + 0.25^1.3), 255 d^(1 / 2.2), truncated. NaN gives 0.
[[nodiscard]] std::uint8_t toneMapped(double component);

/// The bytes of all three components: red, green, blue.
[[nodiscard]] std::array<std::uint8_t, 3> toneMapped(const ColourRGB& colour);

}  // namespace raytracer

#endif
