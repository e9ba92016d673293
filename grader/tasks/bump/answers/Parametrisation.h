#ifndef TICKER_TASKS_BUMP_PARAMETRISATION_H
#define TICKER_TASKS_BUMP_PARAMETRISATION_H

#include <raytracer/math/Vector3.h>

#include <optional>
#include <vector>

namespace ticker::tasks::bump {

using raytracer::Vector3;

/// A spherical parametrisation of the map: rows follow the polar angle from `axis`, columns the
/// longitude round it. Directions are unit vectors from the sphere's centre. (u, v) are map
/// coordinates: u from 0 at the left to 1 at the right, v from 0 at the top to 1 at the bottom.
class Parametrisation {
public:
    /// @param axis      Points towards the map's top row; unit length.
    /// @param uOffset   u of the reference meridian, from which `longitude` counts.
    /// @param mirrored  True if columns run to the left, seen from outside with `axis` up.
    Parametrisation(const Vector3& axis, double uOffset, bool mirrored);

    [[nodiscard]] const Vector3& axis() const { return axis_; }
    /// True if the axis is that of the handout, either way up, within 3.6 degrees.
    [[nodiscard]] bool isUpright() const;
    [[nodiscard]] bool mirrored() const { return mirrored_; }
    [[nodiscard]] double uOffset() const { return uOffset_; }

    [[nodiscard]] double u(const Vector3& direction) const;  ///< in [0, 1)
    [[nodiscard]] double v(const Vector3& direction) const;  ///< in [0, 1]
    /// Radians to the right, counted from the meridian nearest to the camera; if the axis points
    /// nearly along z, from the one nearest to +y.
    [[nodiscard]] double longitude(const Vector3& direction) const;
    /// Unit tangent in the direction of growing columns.
    [[nodiscard]] Vector3 alongU(const Vector3& direction) const;
    /// Unit tangent in the direction of growing rows.
    [[nodiscard]] Vector3 alongV(const Vector3& direction) const;
    /// Unit vector from the centre to the point at (u, v).
    [[nodiscard]] Vector3 direction(double u, double v) const;

private:
    Vector3 axis_;
    Vector3 meridian_;  // longitude 0, at a right angle to the axis
    Vector3 right_;     // longitude a quarter turn
    double uOffset_;
    bool mirrored_;
};

/// True if the point is far enough from the poles and the seam for every finite difference and
/// every interpolation.
[[nodiscard]] bool isOrdinary(const Parametrisation& parametrisation, const Vector3& direction);

/// A point of the sphere and the map coordinates that its tilts show; NaN if they show none.
struct Sighting {
    Vector3 direction;
    double u = 0.0;
    double v = 0.0;
};

/// How well a parametrisation explains the sightings.
struct ParametrisationFit {
    Parametrisation parametrisation;
    double axisLength = 0.0;    ///< length of the fitted axis: 1 if rows follow the polar angle
    double medianUError = 0.0;  ///< turns
    double medianVError = 0.0;  ///< half turns
    double strayShare = 0.0;    ///< points that are off by more than `kStray`

    static constexpr double kStray = 0.05;
    /// True if spherical polar coordinates round some axis explain the sightings. The limits leave
    /// room for one texel, for W - 1 in place of W and for differences over a hundredth of the map.
    /// Rows that follow the height instead of the polar angle have a median error of 0.07.
    [[nodiscard]] bool good() const;
};

/// The best fitting parametrisation; empty with fewer than 50 usable points, or if they show no
/// axis.
[[nodiscard]] std::optional<ParametrisationFit> fitParametrisation(
    const std::vector<Sighting>& sightings);

/// Distance between two periodic map coordinates (period 1); at most 0.5.
[[nodiscard]] double turnDistance(double a, double b);

}  // namespace ticker::tasks::bump

#endif
