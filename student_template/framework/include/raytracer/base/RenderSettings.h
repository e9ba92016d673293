#ifndef RAYTRACER_BASE_RENDERSETTINGS_H
#define RAYTRACER_BASE_RENDERSETTINGS_H

#include <cstdint>

namespace raytracer {

class RenderMonitor;
class RenderObserver;

/// A window of pixels in the full frame; pixel (0, 0) is the top left one.
struct Region {
    int x = 0;
    int y = 0;
    int width = 0;   ///< 0: the whole frame
    int height = 0;  ///< 0: the whole frame

    [[nodiscard]] bool isWholeFrame() const { return width <= 0 || height <= 0; }
};

/// How to render: the handout's constants, as data.
struct RenderSettings {
    int width = 640;   ///< full frame, pixels
    int height = 480;  ///< full frame, pixels
    int bounces = 2;   ///< reflections followed after the first hit

    int shadowRayCount = 10;  ///< shadow rays for each point and light
    double lightSize = 0.4;   ///< radius of the spherical light, world units

    int dofRayCount = 50;            ///< camera rays for each pixel
    double dofFocalPlane = 3.51805;  ///< z of the plane in focus, world units
    double dofAmount = 0.2;          ///< half of the square aperture's side, world units

    Region region;  ///< part of the full frame to render; its pixels equal those of the whole

    std::uint64_t seed = 0;  ///< `forEachPixel` reseeds the generator from it for every pixel
    int threads = 1;         ///< threads of `forEachPixel`; does not change the picture

    RenderObserver* observer = nullptr;  ///< not owned; null: no observer
    RenderMonitor* monitor = nullptr;    ///< not owned; null: no progress, no interrupt

    /// Width of the image that a render gives, pixels.
    [[nodiscard]] int imageWidth() const { return region.isWholeFrame() ? width : region.width; }
    /// Height of the image that a render gives, pixels.
    [[nodiscard]] int imageHeight() const { return region.isWholeFrame() ? height : region.height; }
};

}  // namespace raytracer

#endif
