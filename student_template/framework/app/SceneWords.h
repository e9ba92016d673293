#ifndef RAYTRACER_APP_SCENEWORDS_H
#define RAYTRACER_APP_SCENEWORDS_H

#include "PixelLog.h"

#include <raytracer/scene/Scene.h>

#include <cstddef>
#include <string>

namespace raytracer {

/// "sphere 2", "plane 1": counted for each kind, in the order of the scene.
[[nodiscard]] std::string nameOf(const Scene& scene, const SceneObject* object);

/// The light that a shadow ray most likely aims at: the one closest to its direction. The scene has
/// lights.
[[nodiscard]] std::size_t aimOf(const Scene& scene, const Ray& ray);

/// True where the ray meets something nearer than the light's centre.
[[nodiscard]] bool isStopped(const SeenRay& seen, const PointLight& light);

/// "(0.5, -0.26, 3.5)": four digits, tiny values as 0.
[[nodiscard]] std::string tripleText(const Vector3& v);
[[nodiscard]] std::string tripleText(const ColourRGB& colour);
[[nodiscard]] std::string numberText(double value);

/// "#8A4C10" of a colour through the tone curve.
[[nodiscard]] std::string hexOf(const ColourRGB& colour);

/// "1 shadow ray", "2 shadow rays".
[[nodiscard]] std::string countedText(std::size_t count, const std::string& noun);

/// "1 arrives", "2 arrive".
[[nodiscard]] std::string arrivingText(std::size_t rays);

}  // namespace raytracer

#endif
