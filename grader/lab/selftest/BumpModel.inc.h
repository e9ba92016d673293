#ifndef TICKER_SELFTEST_BUMPMODEL_INC_H
#define TICKER_SELFTEST_BUMPMODEL_INC_H

// The model for any precision. A header, so that tests can compile it with other options.
#include <grader/lab/selftest/BumpFrame.inc.h>
#include <grader/lab/selftest/BumpModel.h>
#include <grader/lab/selftest/BumpSampler.inc.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace ticker::selftest {
namespace {

/// One call of getNormalAt.
template <typename Real>
class Model {
    using V = Triple<Real>;
    static constexpr Real kPi = std::numbers::pi_v<Real>;

public:
    Model(const Reading& reading, Mistake mistake, const Point& point)
        : reading_(reading),
          mistake_(mistake),
          point_(point),
          frame_(reading, mistake, point),
          heights_(reading, mistake, point.map) {}

    [[nodiscard]] Vector3 normal() {
        const V& n = frame_.normal();
        if (mistake_ == Mistake::behind && n.z > 0) return toVector(n);
        const Vector3 result = toVector(tilted());
        const bool away = mistake_ == Mistake::cameraFacing && result.dot(point_.position) > 0.0;
        return mistake_ == Mistake::inward || away ? -result : result;
    }

private:
    static Vector3 toVector(const V& v) { return {double(v.x), double(v.y), double(v.z)}; }

    /// A difference in the form in which the code stores it.
    [[nodiscard]] Real stored(Real value) const {
        if (mistake_ == Mistake::absolute) return std::abs(value);
        if (mistake_ == Mistake::wholeNumbers) return Real(static_cast<int>(value));
        if (mistake_ == Mistake::falling) return std::max(Real(0), value);
        if (mistake_ == Mistake::byteDifference)
            return Real(static_cast<std::uint8_t>(std::lround(value * 51))) / 51;
        return value;
    }

    void findSlopes() {
        const Real column = frame_.u() * Real(heights_.columnsUsed());
        const Real row = frame_.v() * Real(heights_.rowsUsed());
        const Real uRow = mistake_ == Mistake::firstRow ? Real(0) : row;
        const Real vColumn = mistake_ == Mistake::firstColumn ? Real(0) : column;
        const Real step = mistake_ == Mistake::farNeighbour ? Real(50) : Real(1);
        bu_ = heights_.difference(column, uRow, step, 0);
        bv_ = heights_.difference(vColumn, row, 0, step);
        if (mistake_ == Mistake::sameSlopeTwice) bv_ = bu_;
        if (mistake_ == Mistake::lowRows && row > 300) bu_ = -bu_;
        if (mistake_ == Mistake::farColumns && column > 300) bv_ = -bv_;
        bu_ = stored(bu_), bv_ = stored(bv_);
        if (mistake_ == Mistake::flat || mistake_ == Mistake::vOnly) bu_ = 0;
        if (mistake_ == Mistake::flat || mistake_ == Mistake::uOnly) bv_ = 0;
        if (mistake_ == Mistake::unitGradient) {
            const Real length = std::hypot(bu_, bv_);
            bu_ /= length, bv_ /= length;
        }
    }

    void makeSigns() {
        if (mistake_ == Mistake::invertedU || mistake_ == Mistake::inverted) bu_ = -bu_;
        if (mistake_ == Mistake::invertedV || mistake_ == Mistake::inverted) bv_ = -bv_;
        if (mistake_ == Mistake::swappedHalf) bu_ = -bu_;
        if (frame_.polar() <= kPi / 2) return;
        if (mistake_ == Mistake::hemisphere) bv_ = -bv_;
        if (mistake_ == Mistake::uHemisphere) bu_ = -bu_;
    }

    [[nodiscard]] V tilted() {
        if (isDisplaced(reading_)) return displaced();
        findSlopes();
        makeSigns();
        const V& n = frame_.normal();
        V pu = frame_.tangentU();
        V pv = frame_.tangentV();
        if (mistake_ == Mistake::swapped || mistake_ == Mistake::swappedHalf) std::swap(pu, pv);
        const Real k = Real(reading_.strength);
        V sum;
        switch (reading_.gain) {
            case Reading::Gain::sine:
                sum = n - (pu * (bu_ * std::sin(frame_.polar())) + pv * bv_) * k;
                break;
            case Reading::Gain::inverseSine:
                sum = n -
                      (pu * (bu_ / std::max(std::sin(frame_.polar()), Real(1e-6))) + pv * bv_) * k;
                break;
            case Reading::Gain::mapUnits:
                sum = n - (pu * (bu_ * Real(point_.map.width())) +
                           pv * (bv_ * Real(point_.map.height()))) *
                              (k / Real(100));
                break;
            default:
                sum = n - (pu * bu_ + pv * bv_) * k;
                break;
        }
        const Real sense = reading_.mirrored ? Real(-1) : Real(1);
        if (reading_.gain == Reading::Gain::equation) sum = crossed(pu, pv, k * sense);
        if (reading_.gain == Reading::Gain::blinn)
            sum = crossed(pu, pv, k / pu.cross(pv).dot(frame_.normal()));
        return mistake_ == Mistake::notUnit ? sum : sum.unit();
    }

    /// n + (B_u (n x P_v) - B_v (n x P_u)) k; right if k has the sign of h in P_u x P_v = h n.
    [[nodiscard]] V crossed(const V& pu, const V& pv, Real k) const {
        const V& n = frame_.normal();
        return n + (n.cross(pv) * bu_ - n.cross(pu) * bv_) * k;
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
        const Real u = frame_.u();
        const Real v = frame_.v();
        Chord chord{u + near * du, v + near * dv, u + far * du, v + far * dv, 0, 0};
        const Real nearHeight = heightOver(chord.nearU, chord.nearV);
        const Real farHeight = heightOver(chord.farU, chord.farV);
        chord.middle = (nearHeight + farHeight) / 2;
        chord.rise = farHeight - nearHeight;
        return chord;
    }

    /// The displaced surface's own normal, by differences over texels.
    [[nodiscard]] V displaced() {
        Chord alongU = chord(Real(1) / Real(heights_.columnsUsed()), 0);
        Chord alongV = chord(0, Real(1) / Real(heights_.rowsUsed()));
        bu_ = alongU.rise, bv_ = alongV.rise;
        makeSigns();
        if (mistake_ == Mistake::swapped || mistake_ == Mistake::swappedHalf) std::swap(bu_, bv_);
        alongU.rise = bu_, alongV.rise = bv_;
        V normal = vectorOf(alongU).cross(vectorOf(alongV)).unit();
        if (normal.dot(frame_.normal()) < 0) normal = normal * Real(-1);
        return normal;
    }

    [[nodiscard]] V vectorOf(const Chord& chord) const {
        return place(chord.farU, chord.farV, chord.middle + chord.rise / 2) -
               place(chord.nearU, chord.nearV, chord.middle - chord.rise / 2);
    }

    [[nodiscard]] Real heightOver(Real u, Real v) const {
        return heights_.heightAt(u * Real(heights_.columnsUsed()), v * Real(heights_.rowsUsed()));
    }

    [[nodiscard]] V place(Real u, Real v, Real height) const {
        const Real longitude = (u - Real(reading_.uOrigin)) * 2 * kPi;
        const bool unitSphere = reading_.gain == Reading::Gain::displacedUnit;
        const Real size = unitSphere ? 1 + Real(reading_.strength / 40) * height
                                     : Real(point_.radius) + Real(reading_.strength) * height;
        return frame_.surface(longitude, v * kPi) * size;
    }

    const Reading& reading_;
    Mistake mistake_;
    const Point& point_;
    BumpFrame<Real> frame_;
    BumpSampler<Real> heights_;
    Real bu_{};
    Real bv_{};
};

/// Compiled with the options of the including file.
inline Vector3 compiledNormal(const Reading& reading, Mistake mistake, const Point& point) {
    if (reading.singlePrecision) return Model<float>(reading, mistake, point).normal();
    return Model<double>(reading, mistake, point).normal();
}

}  // namespace
}  // namespace ticker::selftest

#endif
