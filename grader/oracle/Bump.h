#ifndef TICKER_ORACLE_BUMP_H
#define TICKER_ORACLE_BUMP_H

#include <grader/oracle/Reading.h>

#include <raytracer/geometry/HeightMap.h>

#include <array>

namespace ticker::oracle {

/// The shading normal of a bumpy sphere, unit length, world axes.
///
/// @param outwards  From the sphere's centre to the point; any length but zero.
/// @see  J. F. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978; handout, Equation (1).
[[nodiscard]] std::array<double, 3> bumpedNormal(const raytracer::HeightMap& map,
                                                 const BumpReading& reading,
                                                 const double outwards[3]);

}  // namespace ticker::oracle

#endif
