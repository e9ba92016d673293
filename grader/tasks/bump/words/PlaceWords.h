#ifndef TICKER_TASKS_BUMP_PLACEWORDS_H
#define TICKER_TASKS_BUMP_PLACEWORDS_H

#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/Phrases.h>

namespace ticker::tasks::bump {

// Words of bump.wrong for tilts that are wrong in one place of the map or the sphere.

/// A wall where the last column meets the first.
[[nodiscard]] Words seamWords(const MapEdges& edges);
/// The same sphere has other normals where the eye sees it from another side.
[[nodiscard]] Words eyeWords(const Elsewhere& elsewhere);
/// Other tangents near the poles.
[[nodiscard]] Words capWords(const Caps& caps);
/// No slope, an inverted one, or one of a far column, beside the edge of a small map.
[[nodiscard]] Words fewTexelWords(const FewTexels& fewTexels);
/// Equal steps of grey that tilt by different amounts.
[[nodiscard]] Words unevenWords(const EvenSteps& steps);
/// White, or light grey, beside black tilts to the wrong side.
[[nodiscard]] Words sharpStepWords(const SharpSteps& steps);
/// Another place of the map where a coordinate is nearly 0.
[[nodiscard]] Words beltWords(const Belts& belts);
/// The slope of another column or row.
[[nodiscard]] Words otherTexelWords(const OwnTexels& ownTexels);
/// Other slopes on a very small sphere.
[[nodiscard]] Words smallSphereWords(const SlopeAgreement& slopes);

}  // namespace ticker::tasks::bump

#endif
