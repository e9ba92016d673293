#ifndef RAYTRACER_GEOMETRY_BUMPYSPHERE_H
#define RAYTRACER_GEOMETRY_BUMPYSPHERE_H

#include <raytracer/geometry/HeightMap.h>
#include <raytracer/geometry/Sphere.h>

#include <memory>

namespace raytracer {

/// A sphere that looks bumpy: its shape is a smooth sphere, but the slopes of a height map tilt its
/// normals.
class BumpySphere final : public Sphere {
public:
    /// @param heightMap  Not null.
    BumpySphere(const Vector3& centre, double radius, const Material& material,
                std::shared_ptr<const HeightMap> heightMap);

    [[nodiscard]] const HeightMap& heightMap() const { return *heightMap_; }

    /// Task T1, in exercise/BumpySphere.cpp: the normal, tilted by the slope of the height map.
    ///
    /// @param position  Point on the sphere, world space.
    /// @return          Unit length, world space, pointing outwards. Bright texels are raised.
    /// @see             handout, option 1, Equations (1) to (3); J. F. Blinn, "Simulation of
    ///                  Wrinkled Surfaces", SIGGRAPH 1978.
    [[nodiscard]] Vector3 getNormalAt(const Vector3& position) const override;

private:
    std::shared_ptr<const HeightMap> heightMap_;
};

}  // namespace raytracer

#endif
