#ifndef RAYTRACER_APP_VIEW_DRAWINGJSON_H
#define RAYTRACER_APP_VIEW_DRAWINGJSON_H

#include "../Options.h"
#include "../PixelLog.h"

#include <raytracer/base/RenderSettings.h>
#include <raytracer/scene/Scene.h>

#include <string>

namespace raytracer::view {

/// What page/drawing.js draws of a pixel, as JSON: the scene, every ray with its words, the normals
/// of the first hits.
[[nodiscard]] std::string drawingOfPixel(const PixelLog& log, const Scene& scene,
                                         const RenderSettings& settings, const Pixel& pixel);

/// The same of a point of a surface that `illuminate` was asked about.
[[nodiscard]] std::string drawingOfPoint(const PixelLog& log, const Scene& scene,
                                         const RenderSettings& settings, const RaycastHit& point,
                                         const ColourRGB& colour);

}  // namespace raytracer::view

#endif
