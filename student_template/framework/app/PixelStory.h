#ifndef RAYTRACER_APP_PIXELSTORY_H
#define RAYTRACER_APP_PIXELSTORY_H

#include "PixelLog.h"

#include <raytracer/scene/Scene.h>

#include <string>

namespace raytracer {

/// A pixel's log for a person to read: every ray, what it met, how much of each light got through,
/// and the colours that came of it.
/// @param inFull  False: after the first few camera rays one line must do for each.
[[nodiscard]] std::string storyOf(const PixelLog& log, const Scene& scene, bool inFull);

}  // namespace raytracer

#endif
