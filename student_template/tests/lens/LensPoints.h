#ifndef LENS_LENSPOINTS_H
#define LENS_LENSPOINTS_H

#include <lens/DepthOfField.h>
#include <raytracer/math/Vector3.h>

#include <cstddef>
#include <vector>

namespace raytracer::tests::lens {

/// Where the camera rays start, of both pixels together.
struct LensPoints {
    explicit LensPoints(const Trial& trial);

    std::vector<Vector3> points;
    std::size_t distinct = 0;
    Vector3 low{1e9, 1e9, 1e9};
    Vector3 high{-1e9, -1e9, -1e9};

    /// Half a side of the smallest square around them, and of the largest within.
    [[nodiscard]] double widest() const;
    [[nodiscard]] double narrowest() const;
};

}  // namespace raytracer::tests::lens

#endif
