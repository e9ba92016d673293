#ifndef BUMP_AXISANSWERS_H
#define BUMP_AXISANSWERS_H

#include <bump/BumpSurvey.h>
#include <raytracer/math/Vector3.h>

#include <vector>

namespace raytracer::tests::bump {

/// Texels of a ramp: enough that rounding to texels is negligible.
constexpr int kRampTexels = 1500;

/// Places on the map and tilts on the ramp, at all points, for one axis.
struct AxisAnswers {
    std::vector<double> places;
    std::vector<Vector3> tilts;
};

/// Asks for normals on a ramp and on a bow along u, or along v if `u` is false.
/// @param directions  Directions of the points, from the centre of the sphere.
[[nodiscard]] AxisAnswers askAlong(bool u, const Slope& slope,
                                   const std::vector<Vector3>& directions);

}  // namespace raytracer::tests::bump

#endif
