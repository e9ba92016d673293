#ifndef TICKER_SELFTEST_BUMPMODEL_INC_H
#define TICKER_SELFTEST_BUMPMODEL_INC_H

// The model itself, for any precision. A header, so that tests can compile it with other options.
#include <grader/selftest/BumpModel.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::selftest {
namespace {

template <typename Real>
struct Triple {
    Real x{};
    Real y{};
    Real z{};

    Triple operator+(const Triple& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Triple operator-(const Triple& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Triple operator*(Real s) const { return {x * s, y * s, z * s}; }
    [[nodiscard]] Real dot(const Triple& b) const { return x * b.x + y * b.y + z * b.z; }
    [[nodiscard]] Triple cross(const Triple& b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
    [[nodiscard]] Real length() const { return std::sqrt(dot(*this)); }
    [[nodiscard]] Triple unit() const { return *this * (Real(1) / length()); }
};

/// One call of getNormalAt.
template <typename Real>
class Model {
    using V = Triple<Real>;
    static constexpr Real kPi = std::numbers::pi_v<Real>;

public:
    Model(const Reading& reading, Slip slip, const Point& point)
        : reading_(reading), slip_(slip), map_(point.map), radius_(Real(point.radius)) {
        const Vector3& centre = point.centre;
        const Vector3& p = point.position;
        offset_ = {Real(p.x - centre.x), Real(p.y - centre.y), Real(p.z - centre.z)};
        n_ = offset_.unit();
        lookUp_ = slip == Slip::noCentre ? V{Real(p.x), Real(p.y), Real(p.z)}.unit() : n_;
        setAxes(reading.top);
        setAngles();
    }

    [[nodiscard]] Vector3 normal() {
        const V result = slip_ == Slip::inward ? tilted() * Real(-1) : tilted();
        return {double(result.x), double(result.y), double(result.z)};
    }

private:
    void setAxes(Reading::Top top) {
        const V x{1, 0, 0};
        const V y{0, 1, 0};
        const V z{0, 0, 1};
        switch (top) {
            case Reading::Top::y:
                up_ = y, right_ = x, front_ = z * Real(-1);
                break;
            case Reading::Top::z:
                up_ = z, right_ = x, front_ = y;
                break;
            case Reading::Top::x:
                up_ = x, right_ = y, front_ = z;
                break;
        }
        if (slip_ == Slip::upsideDown) up_ = up_ * Real(-1), right_ = right_ * Real(-1);
    }

    void setAngles() {
        longitude_ = std::atan2(lookUp_.dot(right_), lookUp_.dot(front_));
        if (slip_ == Slip::noQuadrant)
            longitude_ = std::atan(lookUp_.dot(right_) / lookUp_.dot(front_));
        if (reading_.mirrored) longitude_ = -longitude_;
        const Real height = lookUp_.dot(up_);
        polar_ = std::acos(std::clamp(height, Real(-1), Real(1)));
        if (reading_.angle == Reading::PolarAngle::arcTangent) {
            const Real across = std::hypot(lookUp_.dot(right_), lookUp_.dot(front_));
            polar_ = std::atan2(across, height);
        }
        const Real tall = offset_.dot(up_);
        if (slip_ == Slip::acosBeyondOne) polar_ = std::acos(tall);
        if (slip_ == Slip::clampedAcos) polar_ = std::acos(std::clamp(tall, Real(-1), Real(1)));
        const Real turns = longitude_ / (slip_ == Slip::halfTurn ? kPi : 2 * kPi);
        u_ = fraction(turns + Real(reading_.uOrigin));
        v_ = slip_ == Slip::evenRows ? (1 - height) / 2 : polar_ / kPi;
    }

    static Real fraction(Real value) {
        const Real rest = value - std::floor(value);
        return rest < 1 ? rest : Real(0);
    }

    /// The unit sphere's point at a longitude and a polar angle.
    [[nodiscard]] V surface(Real longitude, Real polar) const {
        const Real turn = reading_.mirrored ? -longitude : longitude;
        return front_ * (std::cos(turn) * std::sin(polar)) +
               right_ * (std::sin(turn) * std::sin(polar)) + up_ * std::cos(polar);
    }

    [[nodiscard]] Real tangentSense() const {
        return reading_.mirrored != (slip_ == Slip::otherSense) ? Real(-1) : Real(1);
    }

    [[nodiscard]] V tangentU() const {
        const Real turn = longitude_ + (slip_ == Slip::otherOrigin ? kPi / 2 : Real(0));
        if (slip_ == Slip::otherAxis)  // the formula of another axis, with these angles
            return right_ * -std::sin(turn) + up_ * std::cos(turn);
        if (reading_.tangents == Reading::Tangents::numeric && slip_ != Slip::otherSense) {
            const Real step = Real(0.001);
            return (surface(turn + step, polar_) - surface(turn - step, polar_)).unit();
        }
        const Real sense = tangentSense();
        return front_ * -std::sin(turn) + right_ * (sense * std::cos(turn));
    }

    [[nodiscard]] V tangentV() const {
        const Real turn = longitude_ + (slip_ == Slip::otherOrigin ? kPi / 2 : Real(0));
        const Real s = std::sin(polar_);
        const Real c = std::cos(polar_);
        if (slip_ == Slip::otherAxis)
            return right_ * (std::cos(turn) * c) + up_ * (std::sin(turn) * c) - front_ * s;
        if (reading_.tangents == Reading::Tangents::numeric && slip_ != Slip::otherSense) {
            const Real step = Real(0.001);
            return (surface(turn, polar_ + step) - surface(turn, polar_ - step)).unit();
        }
        const Real sense = tangentSense();
        return front_ * (std::cos(turn) * c) + right_ * (sense * std::sin(turn) * c) - up_ * s;
    }

    [[nodiscard]] int columnsUsed() const { return map_.width() - (reading_.lessOne ? 1 : 0); }
    [[nodiscard]] int rowsUsed() const { return map_.height() - (reading_.lessOne ? 1 : 0); }

    static int mirror(int index, int count) {
        if (index < 0) return std::min(-index, count - 1);
        return index < count ? index : std::max(0, 2 * count - 2 - index);
    }

    [[nodiscard]] Real height(int column, int row) const {
        const int w = map_.width();
        const int h = map_.height();
        int c = column;
        int r = row;
        const bool bareColumn = slip_ == Slip::noWrap;
        const bool bareRow = slip_ == Slip::noLastRow;
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
        if (slip_ == Slip::transposed) return Real(map_.at(r % w, c % h));
        return Real(map_.at(c, r));
    }

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

    static int whole(Real value) { return static_cast<int>(std::floor(value)); }

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

    static Real cut(Real value) { return Real(static_cast<int>(value)); }

    void findSlopes() {
        const Real column = u_ * Real(columnsUsed());
        const Real row = v_ * Real(rowsUsed());
        const Real uRow = slip_ == Slip::firstRow ? Real(0) : row;
        bu_ = difference(column, uRow, 1, 0);
        bv_ = slip_ == Slip::sameSlopeTwice ? bu_ : difference(column, row, 0, 1);
        if (slip_ == Slip::absolute) bu_ = std::abs(bu_), bv_ = std::abs(bv_);
        if (slip_ == Slip::wholeNumbers) bu_ = cut(bu_), bv_ = cut(bv_);
        if (slip_ == Slip::flat || slip_ == Slip::vOnly) bu_ = 0;
        if (slip_ == Slip::flat || slip_ == Slip::uOnly) bv_ = 0;
        if (slip_ == Slip::unitGradient) {
            const Real length = std::hypot(bu_, bv_);
            bu_ /= length, bv_ /= length;
        }
    }

    void makeSigns() {
        if (slip_ == Slip::invertedU || slip_ == Slip::inverted) bu_ = -bu_;
        if (slip_ == Slip::invertedV || slip_ == Slip::inverted) bv_ = -bv_;
        if (slip_ == Slip::swappedHalf) bu_ = -bu_;
        if (slip_ == Slip::hemisphere && polar_ > kPi / 2) bv_ = -bv_;
    }

    [[nodiscard]] V tilted() {
        if (isDisplaced(reading_)) return displaced();
        findSlopes();
        makeSigns();
        V pu = tangentU();
        V pv = tangentV();
        if (slip_ == Slip::swapped || slip_ == Slip::swappedHalf) std::swap(pu, pv);
        const Real k = Real(reading_.strength);
        V sum;
        switch (reading_.gain) {
            case Reading::Gain::sine:
                sum = n_ - (pu * (bu_ * std::sin(polar_)) + pv * bv_) * k;
                break;
            case Reading::Gain::inverseSine:
                sum = n_ - (pu * (bu_ / std::max(std::sin(polar_), Real(1e-6))) + pv * bv_) * k;
                break;
            case Reading::Gain::mapUnits:
                sum = n_ - (pu * (bu_ * Real(map_.width())) + pv * (bv_ * Real(map_.height()))) *
                               (k / Real(100));
                break;
            default:
                sum = n_ - (pu * bu_ + pv * bv_) * k;
                break;
        }
        const Real sense = reading_.mirrored ? Real(-1) : Real(1);
        if (reading_.gain == Reading::Gain::equation) sum = crossed(pu, pv, k * sense);
        if (reading_.gain == Reading::Gain::blinn) sum = crossed(pu, pv, k / pu.cross(pv).dot(n_));
        return slip_ == Slip::notUnit ? sum : sum.unit();
    }

    /// n + (B_u (n x P_v) - B_v (n x P_u)) k: right for k of the sign of h in P_u x P_v = h n.
    [[nodiscard]] V crossed(const V& pu, const V& pv, Real k) const {
        return n_ + (n_.cross(pv) * bu_ - n_.cross(pu) * bv_) * k;
    }

    /// One of the displaced surface's chords: its ends on the map, and their heights.
    struct Chord {
        Real nearU{};
        Real nearV{};
        Real farU{};
        Real farV{};
        Real middle{};
        Real rise{};
    };

    [[nodiscard]] Chord chord(Real du, Real dv) const {
        Real near = -1;
        Real far = 1;
        if (reading_.difference == Reading::Difference::forward) near = 0;
        if (reading_.difference == Reading::Difference::backward) far = 0;
        if (reading_.difference == Reading::Difference::wide) near = -3, far = 3;
        Chord chord{u_ + near * du, v_ + near * dv, u_ + far * du, v_ + far * dv, 0, 0};
        const Real nearHeight = heightOver(chord.nearU, chord.nearV);
        const Real farHeight = heightOver(chord.farU, chord.farV);
        chord.middle = (nearHeight + farHeight) / 2;
        chord.rise = farHeight - nearHeight;
        return chord;
    }

    /// The displaced surface's own normal, by differences over texels.
    [[nodiscard]] V displaced() {
        Chord alongU = chord(Real(1) / Real(columnsUsed()), 0);
        Chord alongV = chord(0, Real(1) / Real(rowsUsed()));
        bu_ = alongU.rise, bv_ = alongV.rise;
        makeSigns();
        if (slip_ == Slip::swapped || slip_ == Slip::swappedHalf) std::swap(bu_, bv_);
        alongU.rise = bu_, alongV.rise = bv_;
        V normal = vectorOf(alongU).cross(vectorOf(alongV)).unit();
        if (normal.dot(n_) < 0) normal = normal * Real(-1);
        return normal;
    }

    [[nodiscard]] V vectorOf(const Chord& chord) const {
        return place(chord.farU, chord.farV, chord.middle + chord.rise / 2) -
               place(chord.nearU, chord.nearV, chord.middle - chord.rise / 2);
    }

    [[nodiscard]] Real heightOver(Real u, Real v) const {
        return heightAt(u * Real(columnsUsed()), v * Real(rowsUsed()));
    }

    [[nodiscard]] V place(Real u, Real v, Real height) const {
        const Real longitude = (u - Real(reading_.uOrigin)) * 2 * kPi;
        const bool unitSphere = reading_.gain == Reading::Gain::displacedUnit;
        const Real size = unitSphere ? 1 + Real(reading_.strength / 40) * height
                                     : radius_ + Real(reading_.strength) * height;
        return surface(longitude, v * kPi) * size;
    }

    const Reading& reading_;
    Slip slip_;
    const HeightMap& map_;
    Real radius_;
    V offset_;
    V n_;
    V lookUp_;
    V up_;
    V right_;
    V front_;
    Real longitude_{};
    Real polar_{};
    Real u_{};
    Real v_{};
    Real bu_{};
    Real bv_{};
};

/// Compiled under whatever options the including file has.
inline Vector3 compiledNormal(const Reading& reading, Slip slip, const Point& point) {
    if (reading.singlePrecision) return Model<float>(reading, slip, point).normal();
    return Model<double>(reading, slip, point).normal();
}

}  // namespace
}  // namespace ticker::selftest

#endif
