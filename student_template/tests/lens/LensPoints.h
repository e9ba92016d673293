#ifndef LENS_LENSPOINTS_H
#define LENS_LENSPOINTS_H

#include <lens/DepthOfField.h>
#include <raytracer/math/Vector3.h>

#include <cstddef>
#include <vector>

namespace raytracer::tests::lens {

/// Origins of the camera rays of both pixels, with their bounding box.
struct LensPoints {
    explicit LensPoints(const Trial& trial);

    std::vector<Vector3> points;
    std::size_t distinct = 0;  ///< number of points that differ by about 1e-7 or more
    Vector3 low{1e9, 1e9, 1e9};
    Vector3 high{-1e9, -1e9, -1e9};

    /// Half the longer and half the shorter side of the bounding box in x and y.
    [[nodiscard]] double widest() const;
    [[nodiscard]] double narrowest() const;
};

}  // namespace raytracer::tests::lens

#endif
