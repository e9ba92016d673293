#ifndef TICKER_SELFTEST_BUMPFRAME_INC_H
#define TICKER_SELFTEST_BUMPFRAME_INC_H

// A point of the model's sphere and its tangents, for any precision.
#include <grader/lab/selftest/BumpModel.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// The parametrisation of a reading at one point, with one mistake.
template <typename Real>
class BumpFrame {
    using V = Triple<Real>;
    static constexpr Real kPi = std::numbers::pi_v<Real>;

public:
    BumpFrame(const Reading& reading, Mistake mistake, const Point& point)
        : reading_(reading), mistake_(mistake) {
        const Vector3& centre = point.centre;
        const Vector3& p = point.position;
        offset_ = {Real(p.x - centre.x), Real(p.y - centre.y), Real(p.z - centre.z)};
        n_ = offset_.unit();
        lookUp_ = mistake == Mistake::noCentre ? V{Real(p.x), Real(p.y), Real(p.z)}.unit() : n_;
        setAxes(reading.top);
        setAngles();
    }

    [[nodiscard]] const V& normal() const { return n_; }
    [[nodiscard]] Real polar() const { return polar_; }
    [[nodiscard]] Real u() const { return u_; }
    [[nodiscard]] Real v() const { return v_; }

    /// The unit sphere's point at a longitude and a polar angle.
    [[nodiscard]] V surface(Real longitude, Real polar) const {
        const Real turn = reading_.mirrored ? -longitude : longitude;
        return front_ * (std::cos(turn) * std::sin(polar)) +
               right_ * (std::sin(turn) * std::sin(polar)) + up_ * std::cos(polar);
    }

    [[nodiscard]] V tangentU() const {
        const Real turn = longitude_ + (mistake_ == Mistake::otherOrigin ? kPi / 2 : Real(0));
        if (mistake_ == Mistake::otherAxis)  // the formula of another axis, with these angles
            return right_ * -std::sin(turn) + up_ * std::cos(turn);
        if (reading_.tangents == Reading::Tangents::numeric && mistake_ != Mistake::otherSense) {
            const Real step = Real(0.001);
            return (surface(turn + step, polar_) - surface(turn - step, polar_)).unit();
        }
        const Real sense = tangentSense();
        return front_ * -std::sin(turn) + right_ * (sense * std::cos(turn));
    }

    [[nodiscard]] V tangentV() const {
        const Real turn = longitude_ + (mistake_ == Mistake::otherOrigin ? kPi / 2 : Real(0));
        const Real s = std::sin(polar_);
        const Real c = std::cos(polar_);
        if (mistake_ == Mistake::otherAxis)
            return right_ * (std::cos(turn) * c) + up_ * (std::sin(turn) * c) - front_ * s;
        if (reading_.tangents == Reading::Tangents::numeric && mistake_ != Mistake::otherSense) {
            const Real step = Real(0.001);
            return (surface(turn, polar_ + step) - surface(turn, polar_ - step)).unit();
        }
        const Real sense = tangentSense();
        return front_ * (std::cos(turn) * c) + right_ * (sense * std::sin(turn) * c) - up_ * s;
    }

private:
    [[nodiscard]] Real tangentSense() const {
        return reading_.mirrored != (mistake_ == Mistake::otherSense) ? Real(-1) : Real(1);
    }

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
        if (mistake_ == Mistake::upsideDown) up_ = up_ * Real(-1), right_ = right_ * Real(-1);
    }

    void setAngles() {
        longitude_ = std::atan2(lookUp_.dot(right_), lookUp_.dot(front_));
        if (mistake_ == Mistake::noQuadrant)
            longitude_ = std::atan(lookUp_.dot(right_) / lookUp_.dot(front_));
        if (reading_.mirrored) longitude_ = -longitude_;
        const Real height = lookUp_.dot(up_);
        polar_ = std::acos(std::clamp(height, Real(-1), Real(1)));
        if (reading_.angle == Reading::PolarAngle::arcTangent) {
            const Real across = std::hypot(lookUp_.dot(right_), lookUp_.dot(front_));
            polar_ = std::atan2(across, height);
        }
        const Real tall = offset_.dot(up_);
        if (mistake_ == Mistake::acosBeyondOne) polar_ = std::acos(tall);
        if (mistake_ == Mistake::clampedAcos)
            polar_ = std::acos(std::clamp(tall, Real(-1), Real(1)));
        const Real turns = longitude_ / (mistake_ == Mistake::halfTurn ? kPi : 2 * kPi);
        u_ = fraction(turns + Real(reading_.uOrigin));
        v_ = mistake_ == Mistake::evenRows ? (1 - height) / 2 : polar_ / kPi;
        if (mistake_ == Mistake::halfRows) v_ /= 2;
    }

    static Real fraction(Real value) {
        const Real rest = value - std::floor(value);
        return rest < 1 ? rest : Real(0);
    }

    const Reading& reading_;
    Mistake mistake_;
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
};

}  // namespace
}  // namespace ticker::selftest

#endif
