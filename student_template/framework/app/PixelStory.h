#ifndef RAYTRACER_APP_PIXELSTORY_H
#define RAYTRACER_APP_PIXELSTORY_H

#include "PixelLog.h"

#include <raytracer/scene/Scene.h>

#include <string>

namespace raytracer {

/// A pixel's log as text for a person: every ray and its hit, the visible share of each light, and
/// the resulting colours.
/// @param inFull  False: after the first few camera rays, one line for each.
[[nodiscard]] std::string storyOf(const PixelLog& log, const Scene& scene, bool inFull);

}  // namespace raytracer

#endif
