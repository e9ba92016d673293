#ifndef RAYTRACER_SCENE_CAMERA_H
#define RAYTRACER_SCENE_CAMERA_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/math/Ray.h>

namespace raytracer {

/// A pinhole camera at the origin: looks along +z, x to the right, y up; horizontal field of view
/// 45 degrees.
class Camera {
public:
    explicit Camera(const RenderSettings& settings);

    /// The ray from the eye through the middle of pixel (x, y) of the image; (0, 0) is top left.
    /// Its direction has unit length. If the settings have a region, (x, y) is counted from the
    /// region's corner.
    [[nodiscard]] Ray castRay(int x, int y) const;

private:
    RenderSettings settings_;
    double pitch_;  // distance of neighbouring pixels on the plane z = 1
};

}  // namespace raytracer

#endif
