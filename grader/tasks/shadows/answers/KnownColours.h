#ifndef TICKER_TASKS_SHADOWS_ANSWERS_KNOWNCOLOURS_H
#define TICKER_TASKS_SHADOWS_ANSWERS_KNOWNCOLOURS_H

#include <grader/result/Finding.h>
#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <vector>

namespace ticker::tasks {

/// The point's colour without any shadow.
[[nodiscard]] ColourRGB inFullLight(const PointLog& point,
                                    const raytracer::SceneDescription& scene);

/// Whether two colours differ by at most `slack`, channel by channel.
[[nodiscard]] bool near(const ColourRGB& a, const ColourRGB& b, const ColourRGB& slack);

/// Whether a point in full light or full shadow of every light has about the colour that follows
/// from geometry; true for all other points. Readings with a term for each sample differ from the
/// central reading by terms of the light's angular size; beside a narrow highlight by more, but
/// never leave the interval that single aims give.
[[nodiscard]] bool isNearKnown(const PointLog& point, const ShadowLog& log, bool viewerIsEye);

/// isNearKnown for all points.
[[nodiscard]] bool allNearKnown(const std::vector<const ShadowLog*>& logs, bool viewerIsEye);

/// The finding of a named mistake.
/// @param arithmetic  One of `namedMistakes`.
[[nodiscard]] Finding findingOf(ShadowArithmetic arithmetic);

/// Lights are lost if another one shines on the back of the surface.
[[nodiscard]] Finding lightsLostBehind();

/// The ambient light is added once for each light.
[[nodiscard]] Finding ambientForEachLight();

/// Only one of several objects casts its shadow.
[[nodiscard]] Finding oneObjectCasts();

/// One object in front of the light casts its shadow, but several in line do not.
[[nodiscard]] Finding hitsMistaken();

/// Objects cast their shadows, except those close to the light.
[[nodiscard]] Finding nearLightMissed();

/// Planes cast no shadow, but spheres do.
[[nodiscard]] Finding planesCastNothing();

/// All mistakes that `findingOf` has a finding for, in the order in which they are tried.
[[nodiscard]] const std::vector<ShadowArithmetic>& namedMistakes();

}  // namespace ticker::tasks

#endif
