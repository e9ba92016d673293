#ifndef RAYTRACER_APP_VIEW_STAGES_H
#define RAYTRACER_APP_VIEW_STAGES_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/Scene.h>

#include <functional>
#include <string>

namespace raytracer::view {

/// A part of a picture while it comes: it covers a region of the full frame, perhaps more coarsely.
struct Part {
    Region region;      ///< in pixels of the full frame
    ByteImage picture;  ///< of the region; the whole frame's where it is coarse
    std::string stage;  ///< "4 of 50 rays", empty for the final pixels
    double secondsLeft = 0.0;
    bool isLast = false;
};

using Sink = std::function<void(const Part&)>;

/// Renders a picture so that something is seen at once: the whole frame at a quarter of its width
/// and height with one ray for each pixel, then with more and more of them, then tile by tile as it
/// will be in the end. The tiles are rendered with the settings as they are, so that nothing that a
/// solution does wrong is hidden by the way in which the picture comes.
///
/// @param stop  Asked often; true: the rest is not wanted.
void renderInStages(const Scene& scene, const RenderSettings& settings, const Sink& sink,
                    const std::function<bool()>& stop);

/// The whole picture at once.
[[nodiscard]] ByteImage renderWhole(const Scene& scene, const RenderSettings& settings);

}  // namespace raytracer::view

#endif
