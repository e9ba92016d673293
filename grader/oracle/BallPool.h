#ifndef TICKER_ORACLE_BALLPOOL_H
#define TICKER_ORACLE_BALLPOOL_H

#include <grader/oracle/Reading.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::oracle {

/// A point of a shape around the origin, of radius (of the cube: half-width) 1.
struct AimPoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};
/// Maps `u`, `v`, `w` in [0, 1) to a point of the shape. Uniform numbers give the shape's
/// distribution, without rejection.
[[nodiscard]] AimPoint aimPoint(LightShape shape, double u, double v, double w);

/// Precomputed aim points for student renders: drawing one takes three loads. The points are
/// Roberts's sequence R3 (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences",
/// 2018), so the pool matches the shape's distribution far better than as many random points. They
/// lie in random order, so that neighbours in the pool are nearly independent. Signs may be flipped
/// at random on top of it.
struct BallPool {
    static constexpr std::size_t kSize = 1U << 14U;
    /// A draw starts at a multiple of this: the size of the widest vector.
    static constexpr std::size_t kRow = 16;

    BallPool(LightShape shape, double radius);

    std::vector<float> x, y, z;
    /// The sign bit for each axis in which the shape is symmetric; 0 for the others.
    std::uint32_t flipX, flipY, flipZ;
};

}  // namespace ticker::oracle

#endif
