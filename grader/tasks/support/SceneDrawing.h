#ifndef TICKER_TASKS_SUPPORT_SCENEDRAWING_H
#define TICKER_TASKS_SUPPORT_SCENEDRAWING_H

#include <grader/result/RayDrawing.h>

#include <raytracer/math/Vector3.h>
#include <raytracer/scene/SceneDescription.h>

namespace ticker::tasks {

using raytracer::Vector3;

[[nodiscard]] inline RayDrawing::Point drawn(const Vector3& point) {
    return {point.x, point.y, point.z};
}

/// The objects and lights of a scene, without rays.
[[nodiscard]] RayDrawing drawScene(const raytracer::SceneDescription& scene, double lightSize);

/// The point where a ray first meets an object of the scene, or the point at `reach` if it meets
/// none before that. For drawings only.
/// @param direction  Unit length.
[[nodiscard]] Vector3 endInScene(const raytracer::SceneDescription& scene, const Vector3& origin,
                                 const Vector3& direction, double reach);

}  // namespace ticker::tasks

#endif
