#ifndef RAYTRACER_SCENE_SCENEDESCRIPTION_H
#define RAYTRACER_SCENE_SCENEDESCRIPTION_H

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/geometry/Material.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/PointLight.h>

#include <memory>
#include <vector>

namespace raytracer {

/// A sphere as a scene file tells it; bumpy where it has a height map.
struct SphereDescription {
    Vector3 centre;
    double radius = 1.0;
    Material material;
    std::shared_ptr<const HeightMap> heightMap;  ///< null: smooth
};

/// A plane as a scene file tells it; the normal need not have unit length.
struct PlaneDescription {
    Vector3 point;
    Vector3 normal;
    Material material;
};

/// What is in a scene, as data, with no rendering code: what the scene reader gives and what every
/// renderer starts from.
struct SceneDescription {
    ColourRGB ambientLighting{1.0};  ///< 1 where the file has no ambient light
    std::vector<PointLight> pointLights;
    std::vector<SphereDescription> spheres;
    std::vector<PlaneDescription> planes;
};

}  // namespace raytracer

#endif
