#ifndef RAYTRACER_GEOMETRY_MATERIAL_H
#define RAYTRACER_GEOMETRY_MATERIAL_H

#include <raytracer/image/ColourRGB.h>

namespace raytracer {

/// How a surface reflects light (Phong's model); the defaults are those of every scene element.
struct Material {
    ColourRGB colour;           ///< C_diff
    double phongKD = 0.8;       ///< diffuse coefficient
    double phongKS = 1.2;       ///< specular coefficient
    double phongAlpha = 10.0;   ///< specular exponent
    double reflectivity = 0.3;  ///< share of the mirrored colour, 0 to 1
};

}  // namespace raytracer

#endif
