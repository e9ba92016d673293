#ifndef RAYTRACER_APP_NORMALPICTURE_H
#define RAYTRACER_APP_NORMALPICTURE_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/io/ImageReader.h>
#include <raytracer/scene/Scene.h>

namespace raytracer {

/// The normals that the camera sees, as colours: red from left to right, green from below to above,
/// blue from away to towards the viewer; 128 is zero. Black where there is nothing.
[[nodiscard]] ByteImage normalPicture(const Scene& scene, const RenderSettings& settings);

}  // namespace raytracer

#endif
