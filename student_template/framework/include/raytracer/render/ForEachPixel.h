#ifndef RAYTRACER_RENDER_FOREACHPIXEL_H
#define RAYTRACER_RENDER_FOREACHPIXEL_H

#include <raytracer/image/Image.h>

#include <functional>

namespace raytracer {

/// Calls `function(x, y)` for every pixel of the image, rows in parallel on the number of threads
/// in the image's settings, and reports progress.
///
/// Before each call the thread's generator is reseeded from the settings' seed and the pixel's
/// place in the full frame, so that a seed gives the same pixels for every number of threads and in
/// every region. If the settings' monitor is interrupted, no further row begins. An exception of
/// the function stops the loop and propagates to the caller.
void forEachPixel(const Image& image, const std::function<void(int x, int y)>& function);

}  // namespace raytracer

#endif
