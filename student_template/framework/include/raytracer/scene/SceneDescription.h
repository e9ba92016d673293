#ifndef RAYTRACER_SCENE_SCENEDESCRIPTION_H
#define RAYTRACER_SCENE_SCENEDESCRIPTION_H

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/geometry/Material.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/PointLight.h>

#include <memory>
#include <vector>

namespace raytracer {

/// A sphere of a scene file; bumpy if it has a height map.
struct SphereDescription {
    Vector3 centre;
    double radius = 1.0;
    Material material;
    std::shared_ptr<const HeightMap> heightMap;  ///< null: smooth
};

/// A plane of a scene file; the normal need not have unit length.
struct PlaneDescription {
    Vector3 point;
    Vector3 normal;
    Material material;
};

/// The contents of a scene as data, without rendering code: the result of the scene reader and the
/// input of every renderer.
struct SceneDescription {
    ColourRGB ambientLighting{1.0};  ///< 1 where the file has no ambient light
    std::vector<PointLight> pointLights;
    std::vector<SphereDescription> spheres;
    std::vector<PlaneDescription> planes;
};

}  // namespace raytracer

#endif
