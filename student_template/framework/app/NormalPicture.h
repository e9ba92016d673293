#ifndef RAYTRACER_APP_NORMALPICTURE_H
#define RAYTRACER_APP_NORMALPICTURE_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/Scene.h>

namespace raytracer {

/// The normals that the camera sees, as colours: red for x (to the right), green for y (up), blue
/// for the direction towards the viewer; 128 is zero. Black where no object is hit.
[[nodiscard]] ByteImage normalPicture(const Scene& scene, const RenderSettings& settings);

}  // namespace raytracer

#endif
