#ifndef TICKER_TASKS_SHADOWS_ANSWERS_AIMFEET_H
#define TICKER_TASKS_SHADOWS_ANSWERS_AIMFEET_H

#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/Draw.h>

#include <array>
#include <cstddef>
#include <vector>

namespace ticker::tasks {

/// Distribution functions of expected feet are off by less than this.
inline constexpr double kLatticeError = 0.01;

/// Feet of aim lines (their points nearest to the light's centre), in radii of the light. Five
/// numbers of each foot are compared: the length, and the coordinates along two axes at right
/// angles to the view and along their diagonals. Along the view itself a foot only shows the
/// light's angular size, so that this coordinate is not used.
class Feet {
public:
    void add(const Vector3& foot, const Perpendiculars& sides);
    /// Must be called before any comparison.
    void sort();
    /// Adds feet; both must be sorted, and the result is.
    void merge(const Feet& sorted);

    [[nodiscard]] std::size_t count() const { return values_[0].size(); }
    [[nodiscard]] const std::vector<double>& lengths() const { return values_[0]; }
    [[nodiscard]] double meanLength() const;

    /// Largest distance between the distribution functions, over all five numbers, and the sum of
    /// the distances.
    struct Gaps {
        double worst = 0.0;
        double sum = 0.0;
    };
    /// @param size  Factor on the expected feet.
    [[nodiscard]] Gaps gapsFrom(const Feet& expected, double size) const;

private:
    std::array<std::vector<double>, 5> values_;
};

/// The feet seen from each direction, and all together.
struct Views {
    std::vector<Feet> each;
    Feet all;

    /// Sorts the feet, and builds `all` from `each`.
    void finish();
};

/// Expected feet of lines to points of a shape, from these directions.
[[nodiscard]] Views expectedViews(AimShape shape, const std::vector<Vector3>& directions);

/// Same as `expectedViews(...).all.meanLength()`, but faster.
[[nodiscard]] double expectedMeanLength(AimShape shape, const std::vector<Vector3>& directions);

}  // namespace ticker::tasks

#endif
