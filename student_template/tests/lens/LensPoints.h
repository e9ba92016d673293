#ifndef LENS_LENSPOINTS_H
#define LENS_LENSPOINTS_H

#include <lens/DepthOfField.h>
#include <raytracer/math/Vector3.h>

#include <cstddef>
#include <vector>

namespace raytracer::tests::lens {

/// Starts of the camera rays, of both pixels together.
struct LensPoints {
    explicit LensPoints(const Trial& trial);

    std::vector<Vector3> points;
    std::size_t distinct = 0;
    Vector3 low{1e9, 1e9, 1e9};
    Vector3 high{-1e9, -1e9, -1e9};

    /// Half the longer and half the shorter side, in x and y, of the smallest rectangle around
    /// them.
    [[nodiscard]] double widest() const;
    [[nodiscard]] double narrowest() const;
};

}  // namespace raytracer::tests::lens

#endif
