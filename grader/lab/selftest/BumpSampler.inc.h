#ifndef TICKER_SELFTEST_BUMPSAMPLER_INC_H
#define TICKER_SELFTEST_BUMPSAMPLER_INC_H

// Heights of the model's map and their differences, for any precision.
#include <grader/lab/selftest/BumpModel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ticker::selftest {
namespace {

/// A map as a reading samples it, with one mistake.
template <typename Real>
class BumpSampler {
public:
    BumpSampler(const Reading& reading, Mistake mistake, const HeightMap& map)
        : reading_(reading), mistake_(mistake), map_(map) {}

    /// Factors by which u and v become columns and rows.
    [[nodiscard]] int columnsUsed() const { return used(map_.width()); }
    [[nodiscard]] int rowsUsed() const { return used(map_.height()); }

    /// Height at a place between texels, counted in texels.
    [[nodiscard]] Real heightAt(Real column, Real row) const {
        switch (reading_.sampling) {
            case Reading::Sampling::floor:
                return height(whole(column), whole(row));
            case Reading::Sampling::round:
                return height(whole(column + Real(0.5)), whole(row + Real(0.5)));
            case Reading::Sampling::bilinear:
                return interpolated(column, row, 0, 1);
            case Reading::Sampling::bicubic:
                return interpolated(column, row, -1, 2);
        }
        return 0;
    }

    /// Slope in the direction (dc, dr), in heights per texel.
    [[nodiscard]] Real difference(Real column, Real row, Real dc, Real dr) const {
        const auto at = [&](Real steps) { return heightAt(column + steps * dc, row + steps * dr); };
        switch (reading_.difference) {
            case Reading::Difference::forward:
                return at(1) - at(0);
            case Reading::Difference::backward:
                return at(0) - at(-1);
            case Reading::Difference::central:
                return (at(1) - at(-1)) / 2;
            case Reading::Difference::wide:
                return (at(3) - at(-3)) / 6;
            case Reading::Difference::sobel:
                break;
        }
        Real sum = 0;
        for (int side = -1; side <= 1; ++side) {
            const Real w = side == 0 ? Real(2) : Real(1);
            const Real c = column + Real(side) * dr;
            const Real r = row + Real(side) * dc;
            sum += w * (heightAt(c + dc, r + dr) - heightAt(c - dc, r - dr));
        }
        return sum / 8;
    }

private:
    /// NaN becomes an index far below the map, as on students' processors. Theirs is the smallest
    /// int, whose neighbour overflows; this one has neighbours on both sides.
    static int whole(Real value) {
        constexpr int kFar = 1'000'000'000;
        const Real floor = std::floor(value);
        return std::abs(floor) < Real(kFar) ? static_cast<int>(floor) : -kFar;
    }

    /// Catmull-Rom over four texels, or linear over two.
    static Real weight(Real distance, bool cubic) {
        const Real d = std::abs(distance);
        if (!cubic) return std::max(Real(0), 1 - d);
        if (d < 1) return 1 + d * d * (Real(1.5) * d - Real(2.5));
        return d < 2 ? 2 + d * (-4 + d * (Real(2.5) - Real(0.5) * d)) : Real(0);
    }

    [[nodiscard]] Real interpolated(Real column, Real row, int first, int last) const {
        const bool cubic = last > 1;
        const int c = whole(column);
        const int r = whole(row);
        Real sum = 0;
        for (int j = first; j <= last; ++j)
            for (int i = first; i <= last; ++i)
                sum += height(c + i, r + j) * weight(column - Real(c + i), cubic) *
                       weight(row - Real(r + j), cubic);
        return sum;
    }

    [[nodiscard]] int used(int side) const {
        const int longer = std::max(map_.width(), map_.height());
        return (mistake_ == Mistake::longerSide ? longer : side) - (reading_.lessOne ? 1 : 0);
    }

    static int mirror(int index, int count) {
        if (index < 0) return std::min(-index, count - 1);
        return index < count ? index : std::max(0, 2 * count - 2 - index);
    }

    [[nodiscard]] Real height(int column, int row) const {
        const int w = map_.width();
        const int h = map_.height();
        int c = column;
        int r = row;
        const bool bareColumn = mistake_ == Mistake::noWrap;
        const bool bareRow = mistake_ == Mistake::noLastRow;
        switch (reading_.edge) {
            case Reading::Edge::wrap:
                c = (c % w + w) % w, r = (r % h + h) % h;
                break;
            case Reading::Edge::clamp:
                c = std::clamp(c, 0, w - 1), r = std::clamp(r, 0, h - 1);
                break;
            case Reading::Edge::mirror:
                c = mirror(c, w), r = mirror(r, h);
                break;
        }
        if (bareColumn) c = column;
        if (bareRow) r = row;
        if (mistake_ == Mistake::rowsEnd) r = std::min(r, 511);
        if (mistake_ == Mistake::transposed) return valueOf(map_.at(r % w, c % h));
        return valueOf(map_.at(c, r));
    }

    /// The height as the reading interprets it.
    [[nodiscard]] Real valueOf(double height) const {
        const auto byte = static_cast<int>(std::lround(height * 51.0));
        if (mistake_ == Mistake::signedBytes) return Real(static_cast<std::int8_t>(byte)) / 51;
        if (mistake_ == Mistake::darkHalf) return std::abs(Real(height) - Real(2.5));
        if (mistake_ == Mistake::powered) return std::pow(Real(height), Real(2.2));
        if (mistake_ == Mistake::squared) return Real(height) * Real(height);
        if (mistake_ == Mistake::rooted) return std::sqrt(Real(height));
        switch (reading_.heights) {
            case Reading::Heights::given:
                break;
            case Reading::Heights::rounded:
                return Real(byte) / 51;
        }
        return Real(height);
    }

    const Reading& reading_;
    Mistake mistake_;
    const HeightMap& map_;
};

}  // namespace
}  // namespace ticker::selftest

#endif
