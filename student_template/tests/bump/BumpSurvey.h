#ifndef BUMP_BUMPSURVEY_H
#define BUMP_BUMPSURVEY_H

#include <raytracer/geometry/BumpySphere.h>
#include <raytracer/geometry/HeightMap.h>
#include <raytracer/math/Vector3.h>

#include <array>
#include <vector>

namespace raytracer::tests::bump {

/// What one axis of the map does at one point of the sphere, by the solution's own answers.
struct AxisAtPoint {
    double place = 0.0;  ///< where on the map the point lies, 0 to 1
    Vector3 along;       ///< unit tangent along which the map runs there
    double pace = 0.0;   ///< how much of the map passes in one radian
    Vector3 tilt;        ///< of the normal, where the map rises evenly along the axis
};

struct SurveyPoint {
    Vector3 direction;  ///< from the sphere's centre, unit
    AxisAtPoint u;
    AxisAtPoint v;
};

/// How steeply the survey's maps rise.
struct Slope {
    double rise = 0.3;      ///< height from end to end
    int bytesPerTexel = 0;  ///< if any: in whole bytes, as a picture's, from 0 again after 255
};

/// Asks a solution for normals on ramps and bows along u and along v, around many points. Nothing
/// is assumed about how it lays the map on the sphere: its own answers tell.
class BumpSurvey {
public:
    /// @throws Whatever the solution throws.
    explicit BumpSurvey(const Slope& slope);

    /// Points at which both axes are known: not those at the map's edges, or where nothing tilts.
    [[nodiscard]] const std::vector<SurveyPoint>& points() const { return points_; }
    /// Points that were asked about.
    [[nodiscard]] int asked() const { return asked_; }
    /// Whether one axis does not tilt: the places of the points are unknown.
    [[nodiscard]] bool isLevel() const;
    [[nodiscard]] const Slope& slope() const { return slope_; }
    /// Middle length of the tilt on the ramp along u, along v, and on a flat map.
    [[nodiscard]] double strengthU() const { return strengthU_; }
    [[nodiscard]] double strengthV() const { return strengthV_; }
    [[nodiscard]] double strengthOnFlat() const { return strengthOnFlat_; }
    /// Where the map's top edge lies on the sphere, unit length.
    [[nodiscard]] Vector3 top() const;

private:
    Slope slope_;
    std::vector<SurveyPoint> points_;
    int asked_ = 0;
    double strengthU_ = 0.0;
    double strengthV_ = 0.0;
    double strengthOnFlat_ = 0.0;
};

/// A sphere that stays where it is for good, with its map: a solution may remember either by its
/// address.
[[nodiscard]] const BumpySphere& keptSphere(const Vector3& centre, double radius,
                                            const HeightMap& map);

/// The normals that a solution gives for a sphere with this map, as tilts of the smooth normal.
/// @param directions  Of the points, from the centre of the sphere.
[[nodiscard]] std::vector<Vector3> tiltsOn(const HeightMap& map,
                                           const std::vector<Vector3>& directions);

/// The same, less what it tilts on a flat map: a displaced surface made of chords leans even there.
[[nodiscard]] std::vector<Vector3> tiltsBeyondFlat(const HeightMap& map,
                                                   const std::vector<Vector3>& directions);

/// A map of `columns` heights by `rows` heights, added.
[[nodiscard]] HeightMap mapOf(const std::vector<double>& columns, const std::vector<double>& rows);

/// Median of the values that are not NaN; 0 if there are none.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace raytracer::tests::bump

#endif
