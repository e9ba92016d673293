#ifndef TICKER_ORACLE_BALLPOOL_H
#define TICKER_ORACLE_BALLPOOL_H

#include <grader/oracle/Reading.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::oracle {

/// A point of the shape that `u`, `v`, `w` in [0, 1) stand for; uniform numbers give the shape's
/// distribution, without rejection.
struct AimPoint {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};
[[nodiscard]] AimPoint aimPoint(LightShape shape, double u, double v, double w);

/// Aim points made ahead, for student renders: drawing one costs three loads. The points are
/// Roberts's sequence R3 (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences",
/// 2018), so that the pool's own distribution is far closer to the shape's than as many
/// random points, in random order, so that what lies together in the pool is as good as
/// independent. Signs may be flipped at random on top of it.
struct BallPool {
    static constexpr std::size_t kSize = 1U << 14U;
    /// Rows that a draw starts at: one for each full vector of the widest kind.
    static constexpr std::size_t kRow = 16;

    BallPool(LightShape shape, double radius);

    std::vector<float> x, y, z;
    std::uint32_t flipX, flipY, flipZ;  ///< the sign bit where the shape is symmetric in that axis
};

}  // namespace ticker::oracle

#endif
