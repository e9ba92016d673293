#include <grader/decision/distributed/Phong.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ticker::decision {

PhongTerms phongTerms(const raytracer::Material& material, const raytracer::PointLight& light,
                      const Vector3& normal, const Vector3& toViewer, const Vector3& toLight,
                      double distance) {
    const ColourRGB arriving =
        light.colour() * (light.intensity() / (4.0 * std::numbers::pi * distance * distance));
    const double facing = std::max(0.0, normal.dot(toLight));
    const double mirrored = std::max(0.0, toLight.reflectIn(normal).dot(toViewer));
    return {
        material.colour * arriving * (material.phongKD * facing),
        light.colour() * arriving * (material.phongKS * std::pow(mirrored, material.phongAlpha))};
}

}  // namespace ticker::decision
