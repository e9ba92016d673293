#ifndef TICKER_TASKS_BUMP_PARAMETRISATION_H
#define TICKER_TASKS_BUMP_PARAMETRISATION_H

#include <raytracer/math/Vector3.h>

#include <optional>
#include <vector>

namespace ticker::tasks::bump {

using raytracer::Vector3;

/// Where a submission lays the map on the sphere: row 0 round `axis`, columns round it.
/// Directions are unit vectors from the sphere's centre; (u, v) are map coordinates, 0 to 1 from
/// the left and from the top.
class Parametrisation {
public:
    /// @param axis      Towards the map's top row, unit length.
    /// @param uOffset   u of the reference meridian, which `longitude` counts from.
    /// @param mirrored  True where columns run to the left, seen from outside with `axis` up.
    Parametrisation(const Vector3& axis, double uOffset, bool mirrored);

    [[nodiscard]] const Vector3& axis() const { return axis_; }
    [[nodiscard]] bool mirrored() const { return mirrored_; }
    [[nodiscard]] double uOffset() const { return uOffset_; }

    [[nodiscard]] double u(const Vector3& direction) const;  ///< in [0, 1)
    [[nodiscard]] double v(const Vector3& direction) const;  ///< in [0, 1]
    /// Radians to the right, counted from the meridian nearest to the camera.
    [[nodiscard]] double longitude(const Vector3& direction) const;
    /// The unit tangent along which columns grow.
    [[nodiscard]] Vector3 alongU(const Vector3& direction) const;
    /// The unit tangent along which rows grow.
    [[nodiscard]] Vector3 alongV(const Vector3& direction) const;
    /// The unit vector from the centre to the point at (u, v).
    [[nodiscard]] Vector3 direction(double u, double v) const;

private:
    Vector3 axis_;
    Vector3 meridian_;  // longitude 0, at a right angle to the axis
    Vector3 right_;     // longitude a quarter turn
    double uOffset_;
    bool mirrored_;
};

/// Far enough from poles and seam for any difference and any interpolation.
[[nodiscard]] bool isOrdinary(const Parametrisation& parametrisation, const Vector3& direction);

/// What one point told about the map: its place on the sphere and the map coordinates that its
/// tilts reveal; not a number where they reveal none.
struct Sighting {
    Vector3 direction;
    double u = 0.0;
    double v = 0.0;
};

/// How well a parametrisation explains what was seen.
struct ParametrisationFit {
    Parametrisation parametrisation;
    double axisLength = 0.0;    ///< 1 where rows follow the polar angle
    double medianUError = 0.0;  ///< turns
    double medianVError = 0.0;  ///< half turns
    double strayShare = 0.0;    ///< points that are off by more than `kStray`

    static constexpr double kStray = 0.05;
    /// True where spherical polar coordinates round some axis explain the parametrisation. The
    /// limits leave room for a texel, for W - 1 and for differences over a hundredth of the map;
    /// rows that follow the height instead of the polar angle are off by 0.07 in the median.
    [[nodiscard]] bool good() const;
};

/// The parametrisation that fits best; empty with fewer than 50 usable points.
[[nodiscard]] std::optional<ParametrisationFit> fitParametrisation(
    const std::vector<Sighting>& sightings);

/// The distance of two map coordinates that go round: at most 0.5.
[[nodiscard]] double turnDistance(double a, double b);

}  // namespace ticker::tasks::bump

#endif
