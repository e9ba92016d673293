#ifndef TICKER_TASKS_DISTRIBUTED_AIMFEET_H
#define TICKER_TASKS_DISTRIBUTED_AIMFEET_H

#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/Draw.h>

#include <array>
#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// Distribution functions of expected feet are off by less than this.
inline constexpr double kLatticeError = 0.01;

/// Feet of aim lines, the points next to the light's centre, in radii of the light. What is
/// compared of them: the length, and the place along two axes at right angles to the view and along
/// their diagonals. Along the view itself feet have no extent but for the light's angular size, so
/// that nothing may be read from there.
class Feet {
public:
    void add(const Vector3& foot, const Perpendiculars& sides);
    void add(const Feet& other);
    /// Before anything is compared.
    void sort();

    [[nodiscard]] std::size_t count() const { return values_[0].size(); }
    [[nodiscard]] const std::vector<double>& lengths() const { return values_[0]; }
    [[nodiscard]] double meanLength() const;

    /// Largest distance of the distribution functions of all numbers, and the sum of all of them.
    struct Gaps {
        double worst = 0.0;
        double sum = 0.0;
    };
    /// @param size  By which the expected ones are multiplied.
    [[nodiscard]] Gaps gapsFrom(const Feet& expected, double size) const;

private:
    std::array<std::vector<double>, 5> values_;
};

/// The feet as seen from each direction, and all together.
struct Views {
    std::vector<Feet> each;
    Feet all;

    /// Sorts, and makes `all` of `each`.
    void finish();
};

/// What lines to points of a shape look like from these directions.
[[nodiscard]] Views expectedViews(AimShape shape, const std::vector<Vector3>& directions);

/// `expectedViews(...).all.meanLength()`, sooner.
[[nodiscard]] double expectedMeanLength(AimShape shape, const std::vector<Vector3>& directions);

}  // namespace ticker::tasks

#endif
