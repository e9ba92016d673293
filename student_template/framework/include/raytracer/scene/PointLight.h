#ifndef RAYTRACER_SCENE_POINTLIGHT_H
#define RAYTRACER_SCENE_POINTLIGHT_H

#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>

#include <numbers>

namespace raytracer {

/// A light that shines equally in all directions.
class PointLight {
public:
    PointLight(const Vector3& position, const ColourRGB& colour, double intensity)
        : position_(position), colour_(colour), intensity_(intensity) {}

    /// Centre of the light, world space.
    [[nodiscard]] const Vector3& position() const { return position_; }
    /// The light's own colour, as in the scene file.
    [[nodiscard]] const ColourRGB& colour() const { return colour_; }
    [[nodiscard]] double intensity() const { return intensity_; }

    /// Light at `distance` world units: colour * intensity / (4 pi distance^2).
    [[nodiscard]] ColourRGB illuminationAt(double distance) const {
        return colour_ * (intensity_ / (4.0 * std::numbers::pi * distance * distance));
    }

private:
    Vector3 position_;
    ColourRGB colour_;
    double intensity_;
};

}  // namespace raytracer

#endif
