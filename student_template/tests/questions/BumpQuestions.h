#ifndef QUESTIONS_BUMPQUESTIONS_H
#define QUESTIONS_BUMPQUESTIONS_H

#include <raytracer/math/Vector3.h>

#include <vector>

namespace raytracer::questions {

// The questions about task T1, in the public tests and in the grader alike. The maps are so simple
// that the answers reveal the parametrisation: a solution may choose where u begins, the size of a
// texel's step and the strength of the bumps.

/// Heights of `count` texels in a row, from 0 to `rise` in equal steps.
[[nodiscard]] std::vector<double> ramp(int count, double rise);

/// The same slope at its beginning, level in the middle, falling as steeply at its end.
[[nodiscard]] std::vector<double> bow(int count, double rise);

/// `count` texels of one height.
[[nodiscard]] std::vector<double> level(int count, double height = 0.0);

/// What was added to the smooth normal before normalising, but for its part along it:
/// n' / (n'.n) - n. It inverts the normalisation exactly, so that it grows in proportion to the
/// slope however steep the bumps are. Not finite where n' is not, or lies in the tangent plane.
[[nodiscard]] inline Vector3 tiltOf(const Vector3& normal, const Vector3& smoothNormal) {
    return normal / normal.dot(smoothNormal) - smoothNormal;
}

/// Where on the map a point lies, 0 to 1 along the ramp, from the tilts there on a ramp and on a
/// bow: the bow's slope is that of the ramp times 1 - 2 x, so that the ratio of the two tilts tells
/// x whatever their direction and their strength. Not a number where the ramp tilts nothing.
[[nodiscard]] double placeFromTilts(const Vector3& onRamp, const Vector3& onBow);

}  // namespace raytracer::questions

#endif
