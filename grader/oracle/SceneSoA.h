#ifndef TICKER_ORACLE_SCENESOA_H
#define TICKER_ORACLE_SCENESOA_H

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace ticker::oracle {

/// A scene as one array for each property (structure of arrays), in single precision, so that each
/// vector lane may process another object. Objects are numbered spheres first, then planes. World
/// units.
struct SceneSoA {
    explicit SceneSoA(const raytracer::SceneDescription& scene);

    /// The tables of normals and materials are padded with zeros to a multiple of this: the widest
    /// vector, so that loads never run past the end.
    static constexpr std::size_t kPadding = 16;

    struct Spheres {
        std::vector<float> x, y, z, radius;
        [[nodiscard]] std::size_t size() const { return x.size(); }
    } spheres;

    /// Unit normals; a point p is on the plane where normal . p = offset.
    struct Planes {
        std::vector<float> x, y, z, offset;
        [[nodiscard]] std::size_t size() const { return x.size(); }
    } planes;

    /// The normal at a point p of any object is p * scale - shift, with scale = 1 / radius and
    /// shift = centre / radius for spheres, and scale = 0 and the reversed normal for planes: one
    /// formula without branches.
    struct Normals {
        std::vector<float> scale, shiftX, shiftY, shiftZ;
    } normals;

    struct Materials {
        std::vector<float> red, green, blue, kD, kS, alpha, reflectivity;
        int wholeAlpha = -1;  ///< the exponent of all objects if that is one small integer; else -1
    } materials;

    struct Light {
        float position[3];
        float colour[3];
        float power;  ///< intensity / (4 pi)
    };
    std::vector<Light> lights;
    float ambient[3];

    /// For each object: null where it is smooth.
    std::vector<std::shared_ptr<const raytracer::HeightMap>> heightMaps;
    bool anyBumpy = false;
};

}  // namespace ticker::oracle

#endif
