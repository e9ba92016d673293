#ifndef QUESTIONS_BUMPQUESTIONS_H
#define QUESTIONS_BUMPQUESTIONS_H

#include <raytracer/math/Vector3.h>

#include <vector>

namespace raytracer::questions {

// The questions about task T1, shared by the public tests and the grader. The maps are so simple
// that the answers reveal the parametrisation: a solution may choose where u begins, the size of a
// texel's step and the strength of the bumps.

/// Heights of `count` texels in a row, from 0 to `rise` in equal steps.
[[nodiscard]] std::vector<double> ramp(int count, double rise);

/// A parabola: as steep as the ramp at its beginning, level in the middle, and an equally steep
/// fall at its end.
[[nodiscard]] std::vector<double> bow(int count, double rise);

/// `count` texels of one height.
[[nodiscard]] std::vector<double> level(int count, double height = 0.0);

/// The vector that was added to the smooth normal before normalising, without its part along the
/// normal: n' / (n'.n) - n. It inverts the normalisation exactly, so that it stays proportional to
/// the slope for bumps of any steepness. Not finite if n' is not, or if n' lies in the tangent
/// plane.
[[nodiscard]] inline Vector3 tiltOf(const Vector3& normal, const Vector3& smoothNormal) {
    return normal / normal.dot(smoothNormal) - smoothNormal;
}

/// Place of a point on the map, 0 to 1 along the ramp, from its tilts on a ramp and on a bow. The
/// bow's slope is that of the ramp times 1 - 2 x, so that the ratio of the two tilts gives x for
/// tilts of any direction and strength. NaN if the ramp does not tilt the point.
[[nodiscard]] double placeFromTilts(const Vector3& onRamp, const Vector3& onBow);

}  // namespace raytracer::questions

#endif
