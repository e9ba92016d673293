#ifndef RAYTRACER_GEOMETRY_RAYCASTHIT_H
#define RAYTRACER_GEOMETRY_RAYCASTHIT_H

#include <raytracer/math/Vector3.h>

namespace raytracer {

class SceneObject;

/// Where a ray meets a surface.
struct RaycastHit {
    const SceneObject* object = nullptr;  ///< never null in a hit; owned by the scene
    double distance = 0.0;                ///< along the ray, in lengths of its direction
    Vector3 location;                     ///< world space
    Vector3 normal;                       ///< `object->getNormalAt(location)`, unit length
};

}  // namespace raytracer

#endif
