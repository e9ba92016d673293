#ifndef BUMP_BUMPSURVEY_H
#define BUMP_BUMPSURVEY_H

#include <raytracer/geometry/BumpySphere.h>
#include <raytracer/geometry/HeightMap.h>
#include <raytracer/math/Vector3.h>

#include <array>
#include <vector>

namespace raytracer::tests::bump {

/// One axis of the map at one point of the sphere, from the solution's own answers.
struct AxisAtPoint {
    double place = 0.0;  ///< place of the point on the map, 0 to 1
    Vector3 along;       ///< unit tangent in the direction in which the map runs
    double pace = 0.0;   ///< share of the map in one radian
    Vector3 tilt;        ///< tilt of the normal if the map rises evenly along the axis
};

struct SurveyPoint {
    Vector3 direction;  ///< from the sphere's centre, unit
    AxisAtPoint u;
    AxisAtPoint v;
};

/// Steepness of the survey's maps.
struct Slope {
    double rise = 0.3;      ///< height from end to end
    int bytesPerTexel = 0;  ///< not 0: grey levels for each texel; heights restart at 0 after 255
};

/// Asks a solution for normals on ramps and bows along u and along v, around many points. It
/// assumes nothing about the parametrisation: the solution's own answers show it.
class BumpSurvey {
public:
    /// @throws Any exception of the solution.
    explicit BumpSurvey(const Slope& slope);

    /// Points at which both axes are known. Points at the map's edges, and points without a tilt,
    /// are left out.
    [[nodiscard]] const std::vector<SurveyPoint>& points() const { return points_; }
    /// Number of points that were asked for.
    [[nodiscard]] int asked() const { return asked_; }
    /// True if the normals do not tilt along u, or not along v: the places of the points are then
    /// unknown.
    [[nodiscard]] bool isLevel() const;
    [[nodiscard]] const Slope& slope() const { return slope_; }
    /// Median length of the tilt on the ramp along u, along v, and on a flat map.
    [[nodiscard]] double strengthU() const { return strengthU_; }
    [[nodiscard]] double strengthV() const { return strengthV_; }
    [[nodiscard]] double strengthOnFlat() const { return strengthOnFlat_; }
    /// The point of the sphere at the map's top edge, unit length.
    [[nodiscard]] Vector3 top() const;

private:
    Slope slope_;
    std::vector<SurveyPoint> points_;
    int asked_ = 0;
    double strengthU_ = 0.0;
    double strengthV_ = 0.0;
    double strengthOnFlat_ = 0.0;
};

/// A sphere with its map that is never moved or freed: a solution may remember either by its
/// address.
[[nodiscard]] const BumpySphere& keptSphere(const Vector3& centre, double radius,
                                            const HeightMap& map);

/// The normals of a solution for a sphere with this map, as tilts of the smooth normal.
/// @param directions  Directions of the points, from the centre of the sphere.
[[nodiscard]] std::vector<Vector3> tiltsOn(const HeightMap& map,
                                           const std::vector<Vector3>& directions);

/// The tilts on this map minus those on a flat one: a normal that is computed from chords of a
/// displaced surface is tilted even where the map is flat.
[[nodiscard]] std::vector<Vector3> tiltsBeyondFlat(const HeightMap& map,
                                                   const std::vector<Vector3>& directions);

/// A map whose heights are the sums of `columns` and `rows`.
[[nodiscard]] HeightMap mapOf(const std::vector<double>& columns, const std::vector<double>& rows);

/// Median of the finite values, the upper one of an even number; 0 if no value is finite.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace raytracer::tests::bump

#endif
