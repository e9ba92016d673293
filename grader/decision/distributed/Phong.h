#ifndef TICKER_DECISION_DISTRIBUTED_PHONG_H
#define TICKER_DECISION_DISTRIBUTED_PHONG_H

#include <raytracer/geometry/Material.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/PointLight.h>

namespace ticker::decision {

using raytracer::ColourRGB;
using raytracer::Vector3;

/// What one light adds to a point that nothing shadows.
struct PhongTerms {
    ColourRGB diffuse;
    ColourRGB specular;

    [[nodiscard]] ColourRGB sum() const { return diffuse + specular; }
};

/// Phong's model with the kit's conventions (design, section 4): light falls by 1 / (4 pi d^2), the
/// light's colour enters the specular term twice.
///
/// @param normal    Unit.
/// @param toViewer  Unit.
/// @param toLight   Unit.
/// @param distance  Over which the light falls off, world units.
[[nodiscard]] PhongTerms phongTerms(const raytracer::Material& material,
                                    const raytracer::PointLight& light, const Vector3& normal,
                                    const Vector3& toViewer, const Vector3& toLight,
                                    double distance);

}  // namespace ticker::decision

#endif
