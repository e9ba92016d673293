#ifndef RAYTRACER_APP_VIEW_STAGES_H
#define RAYTRACER_APP_VIEW_STAGES_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/Scene.h>

#include <functional>
#include <string>

namespace raytracer::view {

/// A part of an unfinished picture: a region of the full frame, perhaps at a lower resolution.
struct Part {
    Region region;      ///< in pixels of the full frame
    ByteImage picture;  ///< of the region, with fewer pixels in a coarse stage
    std::string stage;  ///< "4 of 50 rays", empty for the final pixels
    double secondsLeft = 0.0;
    bool isLast = false;
};

using Sink = std::function<void(const Part&)>;

/// Renders a picture so that something is visible at once. First comes the whole frame at a quarter
/// of its width and height, with one ray for each pixel and then with more. The final picture
/// follows in tiles. Tiles are rendered with the unchanged settings, so that the stages hide no
/// mistake of the solution.
///
/// @param stop  Called often; returns true once the rest is not wanted.
void renderInStages(const Scene& scene, const RenderSettings& settings, const Sink& sink,
                    const std::function<bool()>& stop);

/// The whole picture at once.
[[nodiscard]] ByteImage renderWhole(const Scene& scene, const RenderSettings& settings);

}  // namespace raytracer::view

#endif
