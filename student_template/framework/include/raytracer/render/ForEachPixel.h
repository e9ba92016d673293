#ifndef RAYTRACER_RENDER_FOREACHPIXEL_H
#define RAYTRACER_RENDER_FOREACHPIXEL_H

#include <raytracer/image/Image.h>

#include <functional>

namespace raytracer {

/// Calls `function(x, y)` for every pixel of the image, rows in parallel on as many threads as the
/// image's settings say, and reports progress.
///
/// Before each call the thread's generator is reseeded from the settings' seed and the pixel's
/// place in the full frame, so that a picture repeats under a seed whatever the threads or the
/// region. Goes on with no further row once the settings' monitor says that it is interrupted. An
/// exception of the function stops the loop and comes out of this call.
void forEachPixel(const Image& image, const std::function<void(int x, int y)>& function);

}  // namespace raytracer

#endif
